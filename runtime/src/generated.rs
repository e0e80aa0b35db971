//! Small help for generated code.

/// A slice as an array of a known length.
///
/// # Panics
/// If the slice has another length: [`System`](crate::system::System) says which it must have.
#[inline(always)]
pub fn array<T, const N: usize>(slice: &[T]) -> &[T; N] {
    slice
        .try_into()
        .unwrap_or_else(|_| panic!("a slice as long as the model has entries"))
}

/// A slice as an array of a known length, to be written.
///
/// # Panics
/// If the slice has another length: [`System`](crate::system::System) says which it must have.
#[inline(always)]
pub fn array_mut<T, const N: usize>(slice: &mut [T]) -> &mut [T; N] {
    slice
        .try_into()
        .unwrap_or_else(|_| panic!("a slice as long as the model has entries"))
}
