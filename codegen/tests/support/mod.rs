//! What the tests of this crate share.

#![allow(dead_code, reason = "each test uses a part")]

pub mod agreement;
pub mod handmade;
pub mod models;
pub mod oracle;
#[path = "../../../tests/support/random.rs"]
pub mod random;
