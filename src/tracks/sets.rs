//! Sets of features that grow together, each of which knows its images.

use super::{BlockMatches, Conflicts};

/// What came of joining two nodes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Joined {
    /// They make a new set.
    New,
    /// One came to the set of the other.
    Added,
    /// Two sets became one.
    Merged,
    /// They were in one set before.
    Before,
    Conflict,
}

/// Disjoint sets of nodes, each also a ring through which its nodes are walked.
pub(super) struct RaySets<'a> {
    matches: &'a BlockMatches,
    parent: Vec<u32>,
    size: Vec<u32>,
    next: Vec<u32>,
    /// Of each root: the sum of 1 - p over the edges that joined its set.
    doubts: Vec<f64>,
    /// The walk in which an image was met last.
    met: Vec<u32>,
    walk: u32,
}

impl<'a> RaySets<'a> {
    pub(super) fn new(matches: &'a BlockMatches) -> Self {
        let nodes = matches.nodes();
        let parent: Vec<u32> = (0..nodes as u32).collect();
        let (next, met) = (parent.clone(), vec![0; matches.images()]);
        Self { matches, parent, size: vec![1; nodes], next, doubts: vec![0.0; nodes], met, walk: 0 }
    }

    /// The representative of a node's set; paths are halved on the way.
    pub(super) fn root(&mut self, mut node: u32) -> u32 {
        while self.parent[node as usize] != node {
            self.parent[node as usize] = self.parent[self.parent[node as usize] as usize];
            node = self.parent[node as usize];
        }
        node
    }

    /// As [`root`](Self::root), for a look at sets that do not change.
    pub(super) fn root_of(&self, mut node: u32) -> u32 {
        while self.parent[node as usize] != node {
            node = self.parent[node as usize];
        }
        node
    }

    /// Joins the sets of two nodes. Sets that hold the same image stay apart where conflicts are resolved, and are joined where they are
    /// dropped.
    pub(super) fn join(&mut self, nodes: [u32; 2], probability: f32, conflicts: Conflicts) -> Joined {
        let [a, b] = nodes.map(|node| self.root(node));
        if a == b {
            return Joined::Before;
        }
        let conflict = self.share_an_image(a, b);
        if conflict && conflicts == Conflicts::Resolve {
            return Joined::Conflict;
        }
        let [size_a, size_b] = [a, b].map(|root| self.size[root as usize]);
        let (root, child) = if (size_a, b) > (size_b, a) { (a, b) } else { (b, a) };
        self.doubts[root as usize] += self.doubts[child as usize] + 1.0 - f64::from(probability);
        self.parent[child as usize] = root;
        self.size[root as usize] = size_a + size_b;
        self.next.swap(a as usize, b as usize);
        match (size_a, size_b) {
            _ if conflict => Joined::Conflict,
            (1, 1) => Joined::New,
            (1, _) | (_, 1) => Joined::Added,
            _ => Joined::Merged,
        }
    }

    fn share_an_image(&mut self, a: u32, b: u32) -> bool {
        // A set that is larger than the number of images, as where conflicts are dropped, holds one twice: it need not be walked.
        if (self.size[a as usize] + self.size[b as usize]) as usize > self.matches.images() {
            return true;
        }
        self.walk += 1;
        let mut node = a;
        loop {
            self.met[self.matches.image_of(node) as usize] = self.walk;
            node = self.next[node as usize];
            if node == a {
                break;
            }
        }
        node = b;
        loop {
            if self.met[self.matches.image_of(node) as usize] == self.walk {
                return true;
            }
            node = self.next[node as usize];
            if node == b {
                return false;
            }
        }
    }

    /// How improbable it is that the nodes of the set of this root belong together: the sum of 1 - p over the edges that joined it.
    pub(super) fn doubt(&self, root: u32) -> f64 {
        self.doubts[root as usize]
    }

    /// The sets of two nodes or more, by their first node; the nodes of each in ascending order.
    pub(super) fn each(&self, mut visit: impl FnMut(&[u32])) {
        let mut visited = vec![false; self.parent.len()];
        let mut nodes = Vec::new();
        for first in 0..self.parent.len() as u32 {
            if visited[first as usize] || self.next[first as usize] == first {
                continue;
            }
            nodes.clear();
            let mut node = first;
            while !visited[node as usize] {
                visited[node as usize] = true;
                nodes.push(node);
                node = self.next[node as usize];
            }
            nodes.sort_unstable();
            visit(&nodes);
        }
    }
}
