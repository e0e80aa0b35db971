//! Pictures: a run's curves over time as SVG, and a page that shows the whole study.
//!
//! [`panels`] chooses what is worth looking at, [`figure`] draws it, [`layout`] and [`mechanism`]
//! draw the mechanism, [`page`] puts both into one self-contained HTML file with parameters and equations;
//! [`frequency`] draws frequency responses;
//! [`scale`] knows prefixes and ticks, [`svg`] colours, escaping and thinning.

pub mod figure;
pub mod frequency;
mod labels;
mod layout;
pub mod mechanism;
pub mod page;
pub mod panels;
pub mod scale;
mod strokes;
mod svg;
