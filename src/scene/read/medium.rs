use super::node::Node;
use super::reader::{Read, Reader};
use super::variant::Form;
use crate::scene::Medium;

const MEDIA: [Form; 5] = [
    ("Index", "Index(1.5)"),
    ("Speed", "Speed(2e8)"),
    ("Cauchy", "Cauchy([1.5046, 0.0042])"),
    ("Sellmeier", "Sellmeier(b: [1.04, 0.232, 1.01], c: [0.006, 0.02, 103.6])"),
    ("Catalog", "Catalog(\"N-BK7\")"),
];

impl Read for Medium {
    fn read(r: &mut Reader, node: &Node<'_>) -> Option<Self> {
        let variant = r.variant(node, "a medium", &MEDIA)?;
        Some(match variant.name {
            "Index" => Self::Index(variant.value(r, "n")?),
            "Speed" => Self::Speed(variant.value(r, "v")?),
            "Cauchy" => Self::Cauchy(variant.value(r, "coefficients")?),
            "Sellmeier" => {
                let f = variant.fields(r, &["b", "c"])?;
                Self::Sellmeier { b: f.required(r, "b"), c: f.required(r, "c") }
            }
            _ => Self::Catalog(variant.value(r, "name")?),
        })
    }

    fn stand_in() -> Self {
        Self::Index(1.0)
    }
}

/// The coefficients of Sellmeier's formula.
impl Read for [f64; 3] {
    fn read(r: &mut Reader, node: &Node<'_>) -> Option<Self> {
        let numbers = Vec::<f64>::read(r, node)?;
        let found = numbers.len();
        let three = Self::try_from(numbers).ok();
        if three.is_none() {
            let message = format!("Sellmeier's formula takes 3 coefficients, not {found}");
            r.refuse(node, message, "not three", "write three numbers; 0 where a term is not needed");
        }
        three
    }

    fn stand_in() -> Self {
        [f64::NAN; 3]
    }
}
