use crate::geometry::BoxTree;

/// Stretches of one medium that only a few interfaces enclose, with what encloses each: all that a ray inside can meet.
#[derive(Clone, Debug, Default)]
pub(crate) struct Cells {
    /// The cell on the left and on the right of each interface; [`Cells::open`] for none.
    pub(crate) of_sides: Vec<[u32; 2]>,
    /// Where each cell's interfaces begin in `walls`; one entry more than cells.
    pub(crate) begins: Vec<u32>,
    pub(crate) walls: Vec<u32>,
    /// The cells up to this one are convex polygons.
    pub(crate) last_convex: u32,
    /// All interfaces of a system without a search tree.
    pub(crate) few: Vec<u32>,
}

impl Cells {
    /// No cell: what a ray may meet there is not known to be little.
    pub(crate) const OPEN: u32 = Self::open(BoxTree::NO_BOX);
    /// The cell without walls: a ray meets nothing there.
    pub(crate) const NOTHING: u32 = 0;

    /// No cell, but of the search tree the box at a place holds nothing that a ray there may meet.
    pub(crate) const fn open(left_behind: u32) -> u32 {
        left_behind | !BoxTree::NO_BOX
    }

    /// Whether it is no cell, so that all interfaces may have to be looked at.
    pub(crate) fn is_open(cell: u32) -> bool {
        cell & !BoxTree::NO_BOX != 0
    }

    /// The box of the search tree that a ray need not look into where there is no cell.
    #[inline(always)]
    pub(crate) fn left_behind(cell: u32) -> u32 {
        cell & BoxTree::NO_BOX
    }

    /// The cell on a side of an interface.
    #[inline(always)]
    pub(crate) fn of(&self, interface: usize, left: bool) -> u32 {
        self.of_sides[interface][usize::from(!left)]
    }

    /// The interfaces around a cell; `None` for what is no cell.
    #[inline]
    pub(crate) fn walls(&self, cell: u32) -> Option<&[u32]> {
        let cell = cell as usize;
        let (begin, end) = (*self.begins.get(cell)?, *self.begins.get(cell + 1)?);
        Some(&self.walls[begin as usize..end as usize])
    }
}
