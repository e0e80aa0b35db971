//! The catalogue of parts as data: waveforms of drives and friction laws, each built from
//! expressions and handed on as a [`Waveform`](crate::model::Waveform) or
//! [`Friction`](crate::model::Friction) that later stages treat alike.

pub mod friction;
pub mod hinges;
pub mod waveforms;
