//! The hash of a node.
//!
//! Owns a mixture of few words, much quicker than the standard library's, which guards against keys made to
//! collide; operations come from a file that has no interest in that, and a collision costs time only.

use std::hash::Hasher;

/// A quick mixture of the few words of an operation; the table is looked into once a node written.
#[derive(Debug, Default, Clone, Copy)]
pub(super) struct Mixture(u64);

impl Hasher for Mixture {
    fn write(&mut self, bytes: &[u8]) {
        for &byte in bytes {
            self.write_u64(u64::from(byte));
        }
    }

    fn write_u32(&mut self, word: u32) {
        self.write_u64(u64::from(word));
    }

    fn write_u64(&mut self, word: u64) {
        self.0 = (self.0.rotate_left(23) ^ word).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    }

    fn write_isize(&mut self, word: isize) {
        self.write_u64(word as u64);
    }

    fn finish(&self) -> u64 {
        self.0 ^ (self.0 >> 32)
    }
}
