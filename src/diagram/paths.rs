use crate::trace::{TracedRay, Via};

/// A segment of one of several spectral lines, by places in lists.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Member {
    /// Number of the path that it took.
    path: u32,
    line: u32,
    segment: u32,
}

impl Member {
    /// Its line, by its place in the list.
    pub(super) fn line(self) -> usize {
        self.line as usize
    }

    /// Its place within the line's segments.
    pub(super) fn segment(self) -> usize {
        self.segment as usize
    }
}

/// Hands on the segments of one ray's spectral lines, bundled by their paths, in the order of the paths' letters.
pub(super) fn bundles(lines: &[TracedRay], bundle: impl FnMut(&[Member])) {
    let mut paths = Paths { longer: vec![[0; 3]] };
    let mut members: Vec<Member> = Vec::with_capacity(lines.iter().map(|ray| ray.segments.len()).sum());
    for (line, ray) in (0..).zip(lines) {
        let first = members.len();
        for (segment, traced) in (0..).zip(&ray.segments) {
            // A parent stands before its children.
            let parent = traced.parent.and_then(|parent| members.get(first + parent.index()));
            let path = paths.by(parent.map_or(0, |parent| parent.path), traced.via);
            members.push(Member { path, line, segment });
        }
    }
    let ranks = paths.ranks();
    members.iter_mut().for_each(|member| member.path = ranks[member.path as usize]);
    members.sort_unstable();
    members.chunk_by(|a, b| a.path == b.path).for_each(bundle);
}

/// All paths of a ray as a tree, the source's own at its root: no path is spelled out, so that deep ones cost no more.
struct Paths {
    /// Of every path the longer ones by one letter, in the letters' order; 0 where there is none.
    longer: Vec<[u32; 3]>,
}

impl Paths {
    /// The path that goes on from another one.
    fn by(&mut self, path: u32, via: Via) -> u32 {
        let letter = match via {
            Via::Source => return path,
            Via::TotalInternalReflection => 0,
            Via::Reflection => 1,
            Via::Transmission => 2,
        };
        let known = self.longer[path as usize][letter];
        if known != 0 {
            return known;
        }
        let new = u32::try_from(self.longer.len()).unwrap_or(u32::MAX);
        self.longer[path as usize][letter] = new;
        self.longer.push([0; 3]);
        new
    }

    /// Place of every path in the order of their letters.
    fn ranks(&self) -> Vec<u32> {
        let mut ranks = vec![0; self.longer.len()];
        let mut waiting = vec![0];
        for rank in 0.. {
            let Some(path) = waiting.pop() else { break };
            ranks[path as usize] = rank;
            waiting.extend(self.longer[path as usize].iter().rev().filter(|longer| **longer != 0));
        }
        ranks
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ranks_are_the_order_of_the_letters() {
        let mut paths = Paths { longer: vec![[0; 3]] };
        let t = paths.by(0, Via::Transmission);
        let tr = paths.by(t, Via::Reflection);
        let r = paths.by(0, Via::Reflection);
        let ti = paths.by(t, Via::TotalInternalReflection);
        assert_eq!(paths.by(t, Via::Reflection), tr);
        let ranks = paths.ranks();
        assert_eq!([0, r, t, ti, tr].map(|path| ranks[path as usize]), [0, 1, 2, 3, 4]);
    }
}
