use super::node::Node;
use super::reader::{Form, Reader};
use crate::scene::Medium;

const MEDIA: [Form; 5] = [
    ("Index", "Index(1.5)"),
    ("Speed", "Speed(2e8)"),
    ("Cauchy", "Cauchy([1.5046, 0.0042])"),
    ("Sellmeier", "Sellmeier(b: [1.04, 0.232, 1.01], c: [0.006, 0.02, 103.6])"),
    ("Catalog", "Catalog(\"N-BK7\")"),
];

/// A medium in one of its forms.
pub(super) fn medium(r: &mut Reader, node: &Node<'_>) -> Option<Medium> {
    let variant = r.variant(node, "a medium", &MEDIA)?;
    Some(match variant.name {
        "Index" => Medium::Index(variant.value(r, "n").and_then(|n| r.number(&n))?),
        "Speed" => Medium::Speed(variant.value(r, "v").and_then(|v| r.number(&v))?),
        "Cauchy" => Medium::Cauchy(variant.value(r, "coefficients").and_then(|list| r.numbers(&list))?),
        "Sellmeier" => {
            let fields = variant.fields(r, &["b", "c"])?;
            let (b, c) = (fields.required(r, "b", three), fields.required(r, "c", three));
            Medium::Sellmeier { b: b?, c: c? }
        }
        _ => Medium::Catalog(variant.value(r, "name").and_then(|name| r.text(&name))?),
    })
}

fn three(r: &mut Reader, node: &Node<'_>) -> Option<[f64; 3]> {
    let numbers = r.numbers(node)?;
    let found = numbers.len();
    let three = <[f64; 3]>::try_from(numbers).ok();
    if three.is_none() {
        let message = format!("Sellmeier's formula takes 3 coefficients, here are {found}");
        r.refuse(node, message, "not three", "write three numbers; 0 where a term is not needed");
    }
    three
}
