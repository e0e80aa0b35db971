//! What the tests of this crate share.

pub mod handmade;
pub mod oracle;
pub mod random;
