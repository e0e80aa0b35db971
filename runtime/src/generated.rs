//! Small help for generated code.

/// A slice as an array of a known length.
///
/// # Panics
/// If the slice has another length: [`System`](crate::system::System) says which it must have.
#[inline(always)]
pub fn array<const N: usize>(slice: &[f64]) -> &[f64; N] {
    slice
        .try_into()
        .expect("a slice as long as the model has entries")
}

/// A slice as an array of a known length, to be written.
///
/// # Panics
/// If the slice has another length: [`System`](crate::system::System) says which it must have.
#[inline(always)]
pub fn array_mut<const N: usize>(slice: &mut [f64]) -> &mut [f64; N] {
    slice
        .try_into()
        .expect("a slice as long as the model has entries")
}
