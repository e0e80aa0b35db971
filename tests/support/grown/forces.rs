//! What pulls at a grown mechanism.

use std::fmt::Write;

use super::{Grower, length, sub};

impl Grower<'_> {
    /// Gravity, hinges, springs, stacks, a force and a contact.
    pub(super) fn forces(&mut self) {
        let [x, y] = [0; 2].map(|_| self.random.between(-10.0, 10.0));
        let _ = writeln!(self.text, "gravity = ({x:e} m/s^2, {y:e} m/s^2)");
        for (pin, bodies) in self.pins.clone() {
            if bodies.len() < 2 || self.random.coin() {
                continue;
            }
            let names = [0, 1].map(|k| self.frames[bodies[k]].name.clone());
            let (k, c) = (self.random.scale(0.1, 5.0), self.random.scale(1e-5, 1e-3));
            let _ = writeln!(
                self.text,
                "hinge at {pin} between {}, {} {{ stiffness = {k:e} N*m/rad, damping = {c:e} N*m*s/rad }}",
                names[0], names[1]
            );
        }
        for keyword in ["spring", "stack"] {
            if self.random.coin() {
                continue;
            }
            let (first, second) = self.pair();
            let ends = [self.anchor(first), self.anchor(second)];
            if length(sub(ends[0].at, ends[1].at)) < 5e-3 {
                continue;
            }
            let name = self.name('k');
            let (k, c) = (self.random.scale(1e2, 1e4), self.random.scale(1e-2, 1.0));
            let _ = writeln!(
                self.text,
                "{keyword} {name} between {} and {} {{ stiffness = {k:e} N/m, damping = {c:e} N*s/m }}",
                ends[0].name, ends[1].name
            );
            self.features.push(keyword);
        }
        let body = 1 + self.random.below(self.frames.len() - 1);
        let place = self.anchor(body);
        let [x, y] = [0; 2].map(|_| self.random.between(-5.0, 5.0));
        let _ = writeln!(self.text, "force on {} = ({x:e} N, {y:e} N)", place.name);
        let slides: Vec<usize> = (0..self.frames.len())
            .filter(|body| self.frames[*body].guide.is_some())
            .collect();
        let links: Vec<usize> = (0..self.frames.len())
            .filter(|body| self.frames[*body].is_link)
            .collect();
        if slides.is_empty() || links.is_empty() {
            return;
        }
        let slide = slides[self.random.below(slides.len())];
        let link = links[self.random.below(links.len())];
        let place = self.anchor(link);
        let along = self.frames[slide].guide.unwrap_or([1.0, 0.0]);
        let on = self.frames[slide].name.clone();
        let _ = writeln!(
            self.text,
            "param sigma0 = 1e4 N/m, sigma1 = 5 N*s/m, sigma2 = 0.5 N*s/m, mu_s = 0.3, mu_c = 0.2, v_s = 10 mm/s\n\
             contact tip between {} and {on} {{\n  normal = ({:e}, {:e})\n  preload = 2 N\n  \
             friction = lugre(sigma0, sigma1, sigma2, mu_s, mu_c, v_s)\n}}",
            place.name, -along[1], along[0],
        );
        self.features.push("contact");
    }
}
