//! Puts everything into the picture: what has a place in the model stands there, and what has none
//! (slides that only their motion matters of, ground at the far end of a spring) is placed beside
//! what it is joined to, in the direction in which the joint acts.

use crate::assembled::{PlacedContact, Places, Point};

/// A mechanism in which everything has a place, in m.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Layout {
    /// Links: name and corners.
    pub links: Vec<(String, Vec<Point>)>,
    /// Slides.
    pub slides: Vec<SlideAt>,
    /// Named points; whether each is a pin, and whether that pin is fixed to ground.
    pub marks: Vec<(String, Point, Option<bool>)>,
    /// Springs and stacks.
    pub springs: Vec<SpringAt>,
    /// Contacts.
    pub contacts: Vec<ContactAt>,
    /// Whether lengths in the picture mean anything: some two points have places in the model.
    pub to_scale: bool,
    /// Whether something stands where it fits, not where the model says.
    pub fitted: bool,
}

/// A slide in the picture.
#[derive(Clone, Debug, PartialEq)]
pub struct SlideAt {
    /// Its name.
    pub name: String,
    /// Where its block stands.
    pub at: Point,
    /// Direction of its guide.
    pub along: Point,
    /// What it touches lies in this direction, so that its rail lies in the other.
    pub touches: Option<Point>,
}

/// A contact in the picture.
#[derive(Clone, Debug, PartialEq)]
pub struct ContactAt {
    /// Its name.
    pub name: String,
    /// Where the bodies touch; for a slide on the ground the slide's place.
    pub at: Point,
    /// Direction of sliding.
    pub along: Point,
    /// The slide that touches ground, by position among the slides: they touch at its rail.
    pub rail_of: Option<usize>,
}

/// A spring in the picture.
#[derive(Clone, Debug, PartialEq)]
pub struct SpringAt {
    /// Its name.
    pub name: String,
    /// Its ends.
    pub ends: [Point; 2],
    /// Whether it ends at a slide's block, by position among the slides.
    pub slides: [Option<usize>; 2],
    /// Whether it ends at ground, in a wall of its own.
    pub walls: [bool; 2],
    /// Whether it is a ceramic stack.
    pub stack: bool,
}

/// Length of a spring without a place, as a share of the mechanism's size.
const SPRING: f64 = 0.26;
const STACK: f64 = 0.36;
/// Distance of a slide from the point that it touches.
const CLEARANCE: f64 = 0.042;
/// Distance of two slides that touch.
const CLEARANCE_OF_SLIDES: f64 = 0.085;
/// Distance of a mechanism's unconnected parts.
const ROW: f64 = 0.3;

/// Places everything.
pub fn layout(places: &Places) -> Layout {
    let known = known_points(places);
    let (size, mut below) = extent(&known);
    let to_scale = size > 0.0;
    let size = if to_scale { size } else { 1.0 };
    let mut at: Vec<Option<Point>> = places.slides.iter().map(|(_, at, _)| *at).collect();
    let fitted = at.iter().any(Option::is_none);
    loop {
        while settle(places, size, &mut at) {}
        // Nothing joins the next one to what stands already: it begins a row of its own.
        let Some(next) = at.iter().position(Option::is_none) else {
            break;
        };
        at[next] = Some(below);
        below[1] -= ROW * size;
    }
    Layout {
        links: places.links.clone(),
        slides: slides(places, &at),
        marks: places.marks.clone(),
        springs: springs(places, size, &at),
        contacts: contacts(places, &at),
        to_scale,
        fitted,
    }
}

fn slide_of(places: &Places, body: &str) -> Option<usize> {
    places.slides.iter().position(|(name, _, _)| name == body)
}

/// The place of an end, as far as it is known by now.
fn end_at(places: &Places, end: &(String, Option<Point>), at: &[Option<Point>]) -> Option<Point> {
    end.1
        .or_else(|| slide_of(places, &end.0).and_then(|slide| at[slide]))
}

/// Places one more slide beside what it is joined to; false if none can be.
fn settle(places: &Places, size: f64, at: &mut [Option<Point>]) -> bool {
    let waiting = |end: &(String, Option<Point>), at: &[Option<Point>]| {
        let slide = slide_of(places, &end.0)?;
        at[slide].is_none().then_some(slide)
    };
    for contact in &places.contacts {
        let [first, second] = &contact.ends;
        let normal = normal(contact);
        for (here, there, sign) in [(first, second, -1.0), (second, first, 1.0)] {
            if let (Some(point), Some(slide)) = (end_at(places, here, at), waiting(there, at)) {
                let clearance = match here.1 {
                    Some(_) => CLEARANCE,
                    None => CLEARANCE_OF_SLIDES,
                };
                at[slide] = Some(shifted(point, normal, sign * clearance * size));
                return true;
            }
        }
    }
    for spring in &places.springs {
        let [first, second] = &spring.ends;
        let axis = spring.axis.unwrap_or([1.0, 0.0]);
        let long = if spring.stack { STACK } else { SPRING } * size;
        for (here, there, sign) in [(first, second, 1.0), (second, first, -1.0)] {
            if let (Some(point), Some(slide)) = (end_at(places, here, at), waiting(there, at)) {
                at[slide] = Some(shifted(point, axis, sign * long));
                return true;
            }
        }
    }
    false
}

/// Unit vector of the normal force on a contact's first end: downwards if the model has none.
fn normal(contact: &PlacedContact) -> Point {
    contact.normal.unwrap_or_else(|| {
        let [x, y] = contact.along;
        if x < 0.0 { [-y, x] } else { [y, -x] }
    })
}

fn slides(places: &Places, at: &[Option<Point>]) -> Vec<SlideAt> {
    let touches = |body: &str| {
        places.contacts.iter().find_map(|contact| {
            let [first, second] = &contact.ends;
            let [x, y] = normal(contact);
            if on_ground(contact) {
                None
            } else if second.0 == body {
                Some([x, y])
            } else if first.0 == body {
                Some([-x, -y])
            } else {
                None
            }
        })
    };
    places
        .slides
        .iter()
        .zip(at)
        .map(|((name, _, along), at)| SlideAt {
            name: name.clone(),
            at: at.unwrap_or([0.0; 2]),
            along: *along,
            touches: touches(name),
        })
        .collect()
}

/// Whether a contact is between a body and ground without a place.
fn on_ground(contact: &PlacedContact) -> bool {
    contact
        .ends
        .iter()
        .any(|end| end.0 == "ground" && end.1.is_none())
}

fn springs(places: &Places, size: f64, at: &[Option<Point>]) -> Vec<SpringAt> {
    let springs = places.springs.iter();
    springs
        .map(|spring| {
            let [first, second] = &spring.ends;
            let axis = spring.axis.unwrap_or([1.0, 0.0]);
            let long = if spring.stack { STACK } else { SPRING } * size;
            let ends = match (end_at(places, first, at), end_at(places, second, at)) {
                (Some(a), Some(b)) => [a, b],
                (Some(a), None) => [a, shifted(a, axis, long)],
                (None, Some(b)) => [shifted(b, axis, -long), b],
                (None, None) => [[0.0; 2], shifted([0.0; 2], axis, long)],
            };
            let at_ground = |end: &(String, Option<Point>)| end.0 == "ground" && end.1.is_none();
            SpringAt {
                name: spring.name.clone(),
                ends,
                slides: [slide_of(places, &first.0), slide_of(places, &second.0)],
                walls: [at_ground(first), at_ground(second)],
                stack: spring.stack,
            }
        })
        .collect()
}

fn contacts(places: &Places, at: &[Option<Point>]) -> Vec<ContactAt> {
    let contacts = places.contacts.iter();
    contacts
        .map(|contact| {
            let [first, second] = &contact.ends;
            let known = (end_at(places, first, at), end_at(places, second, at));
            let place = match (first.1, second.1, known) {
                // At the point that touches; between slides, half way.
                (Some(point), _, _) | (None, Some(point), _) => point,
                (None, None, (Some(a), Some(b))) => [(a[0] + b[0]) / 2.0, (a[1] + b[1]) / 2.0],
                (None, None, (Some(at), None) | (None, Some(at))) => at,
                (None, None, (None, None)) => [0.0; 2],
            };
            let slide = slide_of(places, &first.0).or_else(|| slide_of(places, &second.0));
            ContactAt {
                name: contact.name.clone(),
                at: place,
                along: contact.along,
                rail_of: slide.filter(|_| on_ground(contact)),
            }
        })
        .collect()
}

fn known_points(places: &Places) -> Vec<Point> {
    let links = places.links.iter().flat_map(|(_, corners)| corners.clone());
    let slides = places.slides.iter().filter_map(|(_, at, _)| *at);
    let marks = places.marks.iter().map(|(_, at, _)| *at);
    let ends = places.springs.iter().flat_map(|spring| &spring.ends);
    let contacts = places.contacts.iter().flat_map(|contact| &contact.ends);
    links
        .chain(slides)
        .chain(marks)
        .chain(ends.chain(contacts).filter_map(|end| end.1))
        .filter(|point| point.iter().all(|c| c.is_finite()))
        .collect()
}

/// The larger side of the box around the points, and a place below it.
pub fn extent(points: &[Point]) -> (f64, Point) {
    let Some(first) = points.first() else {
        return (0.0, [0.0; 2]);
    };
    let (low, high) = points.iter().fold((*first, *first), |(low, high), p| {
        (
            [low[0].min(p[0]), low[1].min(p[1])],
            [high[0].max(p[0]), high[1].max(p[1])],
        )
    });
    let size = (high[0] - low[0]).max(high[1] - low[1]);
    (size, [(low[0] + high[0]) / 2.0, low[1] - ROW * size])
}

fn shifted(p: Point, direction: Point, by: f64) -> Point {
    [p[0] + by * direction[0], p[1] + by * direction[1]]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::assembled::PlacedSpring;

    fn end(body: &str, at: Option<Point>) -> (String, Option<Point>) {
        (body.to_owned(), at)
    }

    /// The article's actuator: stack and stage have no place of their own.
    fn actuator() -> Places {
        let spring = |name: &str, ends, stack| PlacedSpring {
            name: name.to_owned(),
            ends,
            axis: Some([-1.0, 0.0]),
            stack,
        };
        Places {
            links: vec![("crank".to_owned(), vec![[0.0, 0.0], [0.0, 10.0]])],
            slides: vec![
                ("stack".to_owned(), None, [-1.0, 0.0]),
                ("stage".to_owned(), None, [-1.0, 0.0]),
            ],
            marks: Vec::new(),
            springs: vec![
                spring("ceramic", [end("ground", None), end("stack", None)], true),
                spring(
                    "joint",
                    [end("stack", None), end("crank", Some([0.0, 5.0]))],
                    false,
                ),
            ],
            contacts: vec![PlacedContact {
                name: "tip".to_owned(),
                ends: [end("coupler", Some([5.0, 10.0])), end("stage", None)],
                along: [-1.0, 0.0],
                normal: Some([0.0, -1.0]),
            }],
        }
    }

    #[test]
    fn what_has_no_place_stands_where_its_joints_act() {
        let layout = layout(&actuator());
        assert!(layout.to_scale && layout.fitted);
        let stack = layout.slides[0].at;
        assert!(stack[0] > 0.0 && stack[1] == 5.0, "right of the crank");
        let [wall, _] = layout.springs[0].ends;
        assert!(wall[0] > stack[0] && layout.springs[0].walls[0]);
        let stage = &layout.slides[1];
        assert!(
            stage.at[0] == 5.0 && stage.at[1] > 10.0,
            "above the coupler"
        );
        assert_eq!(stage.touches, Some([0.0, -1.0]));
    }

    #[test]
    fn slides_alone_get_a_row_and_no_scale() {
        let mut places = actuator();
        places.links.clear();
        places.springs.truncate(1);
        places.contacts.clear();
        let layout = layout(&places);
        assert!(!layout.to_scale);
        assert_ne!(layout.slides[0].at, layout.slides[1].at);
        assert_eq!(self::layout(&Places::default()), Layout::default());
    }
}
