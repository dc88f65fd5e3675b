//! From a scene to an optical system: outlines placed, overlaps resolved, coincident boundaries merged, coatings laid on,
//! and the medium on each side of every boundary settled once.

mod arrangement;
mod cells;
mod centered;
mod cuts;
mod effort;
mod gaps;
mod interfaces;
mod leaders;
mod lists;
mod object;
mod origin;
mod outlook;
mod proportion;
mod region;
mod runs;
mod shapes;
mod sources;
mod starts;

use std::collections::HashMap;

use glam::DVec2;

use crate::compile::arrangement::{Boundary, arrange};
use crate::compile::effort::{Effort, Exhausted};
use crate::compile::gaps::{Gap, Gaps, gaps};
use crate::compile::interfaces::{OutlineRole, Sides, is_interface};
use crate::compile::region::Regions;
use crate::compile::runs::Runs;
use crate::compile::sources::{Ground, first_points};
use crate::geometry::{Bounds, Curve, CurveTree, Placement};
use crate::media::Dispersion;
use crate::scene::{Body, Limits, Medium, Problem, Problems, Scene, Severity, Substance, Surface};
use crate::system::{Cells, Interface, MediumId, OpticalSystem, Outline, PlacedBody, rounding};

pub use effort::MAX_COMPARISONS;

/// So many interfaces are looked at one by one faster than a search finds them.
const FEW: usize = 16;

/// A compiled scene and what is suspicious about it.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Compiled {
    /// The system, ready to trace.
    pub system: OpticalSystem,
    /// Legal things that are probably not meant.
    pub warnings: Vec<Problem>,
}

/// Compiles a scene within the usual [`Limits`].
///
/// # Errors
///
/// Every problem of the scene at once, each with its place, what is wrong and what would be right.
pub fn compile(scene: &Scene) -> Result<Compiled, Problems> {
    compile_within(scene, &Limits::default())
}

/// [`compile()`] within limits of one's own.
///
/// # Errors
///
/// As those of [`compile()`].
pub fn compile_within(scene: &Scene, limits: &Limits) -> Result<Compiled, Problems> {
    let problems = scene.validate_within(limits);
    if problems.iter().any(|problem| problem.severity == Severity::Error) {
        return Err(unplaced(problems));
    }
    compile_checked(scene).map_err(|problem| unplaced(vec![problem]))
}

/// Compiles a scene that was found free of errors.
pub(crate) fn compile_checked(scene: &Scene) -> Result<Compiled, Problem> {
    let mut media = Media::default();
    let surroundings = media.id(&scene.surroundings)?;
    let mut layout = Layout::default();
    for (number, body) in scene.bodies.iter().enumerate() {
        layout.add(number, body, &mut media)?;
    }
    let origin = origin::origin(layout.bounds(scene));
    let boundaries = layout.boundaries(scene, origin);
    let effort = &Effort::new(MAX_COMPARISONS);
    let of_boundary = |spent: Exhausted| too_close(&layout.roles, boundaries[spent.at].outline);
    let runs = Runs::new(boundaries.iter().map(arrangement::bounds).collect());
    let neighbors = runs.neighbors(gaps::MARGIN, effort).map_err(of_boundary)?;
    let regions = Regions::new(&boundaries, &runs, &layout.media);
    let pairs = runs.pairs(&neighbors, effort).map_err(of_boundary)?;
    let pieces = arrange(&boundaries, &runs, &pairs, effort).map_err(of_boundary)?;
    let sides = Sides {
        boundaries: &boundaries,
        runs: &runs,
        neighbors: &neighbors,
        regions: &regions,
        outlines: &layout.roles,
        surroundings,
        effort,
    };
    let mut walls = sides.walls(&pieces).map_err(of_boundary)?;
    let near = rounding(walls.iter().filter(|wall| is_interface(wall)), origin);
    let dropped: Vec<_> = (0..walls.len()).filter(|k| !is_interface(&walls[*k])).collect();
    let firsts = runs.firsts(pieces.list.iter().map(|piece| piece.boundary));
    let ground = Ground {
        origin,
        walls: &walls,
        dropped,
        runs: &runs,
        firsts,
        near,
        regions: &regions,
        surroundings,
        bodies: &scene.bodies,
        media: &media.list,
        effort,
    };
    let place = |(k, source)| ground.place(k, source).map_err(|_| too_close_to_start(k));
    let sources = scene.sources.iter().enumerate().map(place).collect::<Result<_, _>>()?;
    let kept = pieces.list.iter().zip(&walls).filter(|(_, wall)| is_interface(wall));
    let firsts = runs.firsts(kept.map(|(piece, _)| piece.boundary));
    let dropped = ground.dropped.len();
    walls.retain(is_interface);
    let gaps = gaps(&walls, &firsts, &neighbors, near, effort).map_err(|spent| crowded(walls[spent.at].body))?;
    let mut warnings: Vec<_> = gaps.list.iter().map(|gap| gap_warning(scene, *gap)).collect();
    warnings.extend(gaps.has_more.then(more_gaps));
    warnings.extend(proportion::warning(&layout.bodies, near));
    let is_screen = |body: &Body| matches!(body.substance, Substance::Surface(Surface::Screen));
    let (tree, cells) = where_rays_look(&walls, near);
    let system = OpticalSystem {
        origin,
        near,
        cells,
        tree,
        dropped,
        media: media.list,
        surroundings,
        screens: (0..scene.bodies.len()).filter(|&k| is_screen(&scene.bodies[k])).collect(),
        bodies: layout.bodies,
        sources,
        settings: scene.trace,
        title: scene.title.clone(),
        interfaces: walls,
    };
    warnings.extend(starts::warnings(scene, &system));
    Ok(Compiled { system, warnings })
}

/// The search tree over interfaces, if it is worth it, and the cells.
fn where_rays_look(interfaces: &[Interface], near: f64) -> (Option<CurveTree>, Cells) {
    let tree = CurveTree::new(interfaces.iter().map(|one| &one.curve), near);
    let mut cells = cells::cells(interfaces, &tree, near);
    let tree = Some(tree).filter(|_| interfaces.len() > FEW);
    outlook::note(&mut cells, interfaces, tree.as_ref(), near);
    if tree.is_none() {
        cells.few = (0..).take(interfaces.len()).collect();
    }
    (tree, cells)
}

/// Problems of a scene whose text is not at hand.
fn unplaced(problems: Vec<Problem>) -> Problems {
    Problems::new(problems, String::new(), String::new())
}

/// A scene whose outlines come near each other in too many places, by the body at which that was found.
fn crowded(body: usize) -> Problem {
    let message = format!(
        "the edges of the bodies up to this one come near each other in too many places: to lay them out takes more than \
         {MAX_COMPARISONS} comparisons"
    );
    let help = "use fewer edges, or move bodies apart: work grows with the square of what lies in one place";
    Problem::error(format!("bodies[{body}]"), message, help).label("too much in one place")
}

/// The same by an outline.
fn too_close(roles: &[OutlineRole], outline: usize) -> Problem {
    crowded(roles.get(outline).map_or(0, |role| role.body))
}

/// The same by the source whose rays were to be placed among them.
fn too_close_to_start(source: usize) -> Problem {
    let message = format!(
        "the rays up to this source's start among too many edges: to lay them out takes more than {MAX_COMPARISONS} comparisons"
    );
    let help = "use fewer rays, or move their starts away from where edges crowd";
    Problem::error(format!("sources[{source}]"), message, help).label("too much in one place")
}

fn gap_warning(scene: &Scene, gap: Gap) -> Problem {
    let name = |k: usize| display_name(&scene.bodies[k], k);
    let is_surface = |k: usize| matches!(scene.bodies[k].substance, Substance::Surface(_));
    let cure = if is_surface(gap.earlier) || is_surface(gap.later) {
        "give the surface the same coordinates as what it lies on"
    } else {
        "let the later body overlap the earlier one, or give both the same coordinates there"
    };
    Problem::warning(
        format!("bodies[{}]", gap.later),
        format!("a gap or sliver of {:.2e} between `{}` and `{}`", gap.width, name(gap.earlier), name(gap.later)),
        format!("it is thinner than light (420 nm at 1 unit = 1 mm), and yet rays see it: {cure}"),
    )
}

fn more_gaps() -> Problem {
    let message = format!("more bodies almost touch than the {} pairs that are told", Gaps::MOST);
    Problem::warning("bodies", message, "move bodies apart, or give what shall touch the same coordinates")
}

/// A body's name, or `#k` for the k-th from 0.
fn display_name(body: &Body, number: usize) -> String {
    body.name.clone().unwrap_or_else(|| format!("#{number}"))
}

/// Media in order of their first use, each once.
#[derive(Default)]
struct Media {
    list: Vec<Dispersion>,
    places: HashMap<Dispersion, usize>,
}

impl Media {
    fn id(&mut self, medium: &Medium) -> Result<MediumId, Problem> {
        let dispersion = medium.dispersion()?;
        let place = self.places.get(&dispersion).copied().unwrap_or_else(|| {
            self.list.push(dispersion.clone());
            self.places.insert(dispersion, self.list.len() - 1);
            self.list.len() - 1
        });
        Ok(MediumId(u32::try_from(place).unwrap_or(u32::MAX)))
    }
}

/// The outlines of all bodies, in painter's order.
#[derive(Default)]
struct Layout {
    /// Not in their places until the boundaries are made.
    bodies: Vec<PlacedBody>,
    roles: Vec<OutlineRole>,
    media: Vec<Option<MediumId>>,
}

impl Layout {
    fn add(&mut self, number: usize, body: &Body, media: &mut Media) -> Result<(), Problem> {
        let paths = shapes::outlines(&body.shape);
        let mut outlines = Vec::with_capacity(paths.len());
        for path in paths {
            let (medium, surface) = match (&body.substance, &path.medium) {
                (Substance::Surface(surface), _) => (None, Some(*surface)),
                (Substance::Medium(medium), _) | (Substance::Elements, Some(medium)) => (Some(media.id(medium)?), None),
                (Substance::Elements, None) => (None, None),
            };
            self.roles.push(OutlineRole { body: number, surface, closed: path.closed });
            self.media.push(medium);
            outlines.push(Outline { curves: path.curves, closed: path.closed, medium });
        }
        self.bodies.push(PlacedBody { name: display_name(body, number), outlines });
        Ok(())
    }

    /// The box around all bodies and ray starts, in scene coordinates.
    fn bounds(&self, scene: &Scene) -> Bounds {
        let mut bounds = Bounds::EMPTY;
        for (body, shaped) in scene.bodies.iter().zip(&self.bodies) {
            let placement = Placement::new(body.rotate, body.at);
            for curve in shaped.outlines.iter().flat_map(|outline| &outline.curves) {
                bounds = bounds.union(Bounds::from(&placement.curve(curve)));
            }
        }
        let starts = scene.sources.iter().flat_map(|source| first_points(&source.light));
        bounds.union(Bounds::of(starts))
    }

    /// Every curve relative to the origin, an arc of more than half a circle as two; puts the bodies in their places.
    fn boundaries(&mut self, scene: &Scene, origin: DVec2) -> Vec<Boundary> {
        let count = self.bodies.iter().flat_map(|body| &body.outlines).map(|outline| outline.curves.len()).sum();
        let mut boundaries = Vec::with_capacity(count);
        let mut outline = 0;
        for (body, placed) in scene.bodies.iter().zip(&mut self.bodies) {
            let in_scene = Placement::new(body.rotate, body.at);
            // Placed anew: moving straight to the relative place rounds once, and less.
            let relative = Placement::new(body.rotate, body.at - origin);
            let mut first = None;
            for Outline { curves, .. } in &mut placed.outlines {
                let start = curves.first().map_or(DVec2::ZERO, |curve| relative.point(curve.a));
                let mut along = first.get_or_insert(start).distance(start);
                for curve in curves {
                    let moved = relative.curve(curve);
                    *curve = in_scene.curve(curve);
                    // Both placements round: coordinates far from the origin of the one may be near that of the other.
                    let reach = Bounds::from(&*curve).reach().max(Bounds::from(&moved).reach());
                    let (part, rest) = parts(moved);
                    for curve in [Some(part), rest].into_iter().flatten() {
                        boundaries.push(Boundary { curve, reach, outline, along });
                        along += curve.length();
                    }
                }
                outline += 1;
            }
        }
        boundaries
    }
}

/// A curve as arcs of at most half a circle.
fn parts(curve: Curve) -> (Curve, Option<Curve>) {
    if curve.spans_more_than_half() {
        let [first, second] = curve.halves();
        (first, Some(second))
    } else {
        (curve, None)
    }
}
