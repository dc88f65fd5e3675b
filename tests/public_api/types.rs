//! Every public type can go to another thread and be shared, and survives a panic.

use std::collections::BTreeSet;
use std::fs;
use std::marker::PhantomData;
use std::panic::{RefUnwindSafe, UnwindSafe};
use std::path::Path;

/// Fails to compile for a type that cannot.
fn is_free<T: Send + Sync + UnwindSafe + RefUnwindSafe>(_: PhantomData<T>, name: &'static str) -> &'static str {
    name
}

macro_rules! free {
    ($($module:ident: $($name:ident $(<$life:lifetime>)?),+;)+) => {
        BTreeSet::from([$($((stringify!($module), is_free(PhantomData::<snellius::$module::$name $(<$life>)?>, stringify!($name)))),+),+])
    };
}

fn listed() -> BTreeSet<(&'static str, &'static str)> {
    free! {
        analysis: Axis, Bundle, BundleRay, Confusion, Curve, Focus, Image, ImageKind, Irradiance, LeastDeviation, ObjectImage,
            Paraxial;
        compile: Compiled;
        diagram: Margins, Statistics;
        drawing: Anchor, Cap, Color, Drawing, Fill, Font, Glyph, GlyphStep, Group, Item, Items, Lines, Path, PathStep, Rect,
            Script, Shape, Span, Stroke, Text, Whole;
        explain: Explanation, Part, Step, UnknownAddress;
        geometry: Bounds, CircleRoots, Curve, Placement;
        laws: CardinalPoints, Fresnel, Incidence, IndexError, RayMatrix, Refraction, Shares;
        light: Power, SpectralLine, Wavelength;
        media: Dispersion, MediumError;
        numerics: Sum, Turn;
        render: RenderError;
        scene: Body, DiagramSettings, Direction, Element, Imaging, Light, Limit, Limits, Loaded, Medium, Note, OpticalAxis, PathStep, Places,
            Polarization, Problem, Problems, RayColor, Scene, SecondaryRays, Severity, Shape, Source, Spectrum, Substance,
            Surface, Theme, TraceSettings, View;
        system: Action, Interface, MediumId, OpticalSystem, Outline, PlacedBody, PlacedObject, PlacedSource, RayStart, Start,
            VertexId;
        trace: Crossing, Ending, Hit, PowerBalance, Ray, RayTree, ScreenHit, ScreenRecord, Search<'static>, Segment, SegmentId,
            Summary, Trace, TracedRay, Via, Work;
    }
}

#[test]
fn the_list_holds_every_public_type() {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let listed = listed();
    let modules: BTreeSet<&str> = listed.iter().map(|(module, _)| *module).collect();
    for module in public_modules(&fs::read_to_string(source.join("lib.rs")).unwrap()) {
        let text = fs::read_to_string(source.join(&module).join("mod.rs")).unwrap();
        let own: BTreeSet<&str> = listed.iter().filter(|(of, _)| *of == module).map(|(_, name)| *name).collect();
        let exported = exported(&text);
        let mut exported: BTreeSet<&str> = exported.iter().map(String::as_str).collect();
        // A trait.
        exported.remove("Visitor");
        assert_eq!(own, exported, "{module}");
        assert!(own.is_empty() || modules.contains(module.as_str()));
    }
    // The one public module inside of another.
    is_free(PhantomData::<snellius::media::catalog::Entry>, "Entry");
}

fn public_modules(lib: &str) -> Vec<String> {
    let names = lib.lines().filter_map(|line| line.strip_prefix("pub mod ")?.strip_suffix(';'));
    names.filter(|name| *name != "cli").map(str::to_owned).collect()
}

/// The types that a module exports or defines itself, by their capital letters.
fn exported(text: &str) -> Vec<String> {
    let statements = text.split(';').filter_map(|statement| statement.split("\npub use ").nth(1));
    let names = statements.flat_map(|names| names.split(|c: char| !(c.is_alphanumeric() || c == '_')));
    let defined = text.lines().filter_map(|line| {
        let rest = line.strip_prefix("pub struct ").or_else(|| line.strip_prefix("pub enum "))?;
        rest.split(|c: char| !c.is_alphanumeric()).next()
    });
    let is_type = |name: &&str| name.starts_with(|c: char| c.is_uppercase()) && name.chars().any(char::is_lowercase);
    names.chain(defined).filter(is_type).map(str::to_owned).collect()
}
