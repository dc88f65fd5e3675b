//! PDF: one page of vector graphics, its text as text in the embedded font.
//!
//! Written by ISO 32000-1:2008 (PDF 1.7). The page has no date and no random name: the same figure gives the same bytes.

mod fonts;
mod page;

use miniz_oxide::deflate::compress_to_vec_zlib;
use pdf_writer::writers::Resources;
use pdf_writer::{Filter, Finish, Name, Pdf, Rect, Ref, TextStr};

use crate::drawing::Drawing;
use crate::render::png::RenderError;

use page::{Page, Shared, State};

/// Points to a pixel: 96 pixels are an inch, as in CSS.
const POINTS: f32 = 0.75;
/// How hard to compress, 0 to 10.
const LEVEL: u8 = 6;

/// The figure as a PDF file; the same figure gives the same bytes.
///
/// # Errors
///
/// If the font cannot be reduced to the glyphs that the figure needs.
pub fn pdf(drawing: &Drawing) -> Result<Vec<u8>, RenderError> {
    let mut shared = Shared::default();
    let content = Page::whole(drawing, &mut shared);
    let mut file = File::new();
    let [pages, page, resources] = [(); 3].map(|()| file.next());
    let catalog = file.next();
    file.pdf.catalog(catalog).pages(pages);
    file.pdf.pages(pages).kids([page]).count(1);
    let contents = file.stream(&content);
    let [width, height] = drawing.size.map(single);
    let mut written = file.pdf.page(page);
    written.parent(pages).media_box(Rect::new(0.0, 0.0, POINTS * width, POINTS * height)).contents(contents);
    written.pair(Name(b"Resources"), resources);
    written.group().transparency().color_space().device_rgb();
    written.finish();
    file.resources(resources, &shared, Rect::new(0.0, 0.0, width, height))?;
    file.information(drawing);
    Ok(file.pdf.finish())
}

/// A file that is being written.
struct File {
    pdf: Pdf,
    /// Number of the object written last.
    last: i32,
}

impl File {
    fn new() -> Self {
        Self { pdf: Pdf::new(), last: 0 }
    }

    fn next(&mut self) -> Ref {
        self.last += 1;
        Ref::new(self.last)
    }

    fn stream(&mut self, data: &[u8]) -> Ref {
        let id = self.next();
        self.pdf.stream(id, &compress_to_vec_zlib(data, LEVEL)).filter(Filter::FlateDecode);
        id
    }

    /// What the page and its groups draw with.
    fn resources(&mut self, id: Ref, shared: &Shared, bounds: Rect) -> Result<(), RenderError> {
        let fonts = self.fonts(&shared.fonts)?;
        let groups: Vec<Ref> = shared.groups.iter().map(|content| self.group(content, id, bounds)).collect();
        let mut resources = self.pdf.indirect(id).start::<Resources<'_>>();
        let mut list = resources.fonts();
        for (name, font) in &fonts {
            list.pair(Name(name.as_bytes()), *font);
        }
        list.finish();
        let mut list = resources.x_objects();
        for (number, group) in groups.iter().enumerate() {
            list.pair(Name(Shared::group_name(number).as_bytes()), *group);
        }
        list.finish();
        let mut list = resources.ext_g_states();
        shared.states.iter().for_each(|state| write_state(*state, list.insert(Name(state.name().as_bytes())).start()));
        Ok(())
    }

    /// A group that is put together apart from what lies behind it.
    fn group(&mut self, content: &[u8], resources: Ref, bounds: Rect) -> Ref {
        let id = self.next();
        let data = compress_to_vec_zlib(content, LEVEL);
        let mut form = self.pdf.form_xobject(id, &data);
        form.filter(Filter::FlateDecode);
        form.bbox(bounds);
        form.pair(Name(b"Resources"), resources);
        form.group().transparency().isolated(true).color_space().device_rgb();
        id
    }

    fn information(&mut self, drawing: &Drawing) {
        let id = self.next();
        let mut information = self.pdf.document_info(id);
        information.creator(TextStr("snellius"));
        if !drawing.title.is_empty() {
            information.title(TextStr(&drawing.title));
        }
        if !drawing.description.is_empty() {
            information.subject(TextStr(&drawing.description));
        }
    }
}

fn write_state(state: State, mut written: pdf_writer::writers::ExtGraphicsState<'_>) {
    written.stroking_alpha(state.opacity()).non_stroking_alpha(state.opacity()).blend_mode(state.blend_mode());
}

#[allow(clippy::cast_precision_loss, reason = "far fewer pixels than a float counts")]
fn single(side: u32) -> f32 {
    side as f32
}
