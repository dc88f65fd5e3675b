//! From bytes to a scene, mostly a valid one: few bodies and rays, with corners and faces that are shared, nearly shared, or not.
//!
//! The first choice of each kind is the simple one, so that fewer bytes make a simpler scene.

use arbitrary::Unstructured;
use glam::DVec2;
use snellius::glam;
use snellius::scene::{
    Body, DiagramSettings, Direction, Light, Medium, Note, Polarization, RayColor, Scene, SecondaryRays, Shape, Source,
    Spectrum, Substance, Surface, Theme, TraceSettings, View,
};

/// Makes one scene.
pub struct Generator<'a> {
    bytes: Unstructured<'a>,
    /// About as large as everything in it is.
    scale: f64,
    /// What was written before, to be written again.
    points: Vec<DVec2>,
    lengths: Vec<f64>,
}

/// The scene that these bytes stand for.
pub fn scene(bytes: &[u8]) -> Scene {
    let (points, lengths) = (vec![DVec2::ZERO], vec![1.0]);
    let mut g = Generator { bytes: Unstructured::new(bytes), scale: 1.0, points, lengths };
    if g.one_in(4) {
        g.scale = [10.0, 0.1, 1e3, 1e-6, 1e6, 1e-12, 1e12, 1e-30, 1e29][g.below(9)];
    }
    let mut scene = Scene::default();
    scene.trace = g.trace();
    scene.bodies = (0..g.below(7)).map(|k| g.body(k)).collect();
    scene.sources = (0..g.below(4)).map(|k| g.source(k)).collect();
    (scene.title, scene.caption) = (g.words(), g.words());
    if g.one_in(4) {
        scene.surroundings = g.medium();
    }
    scene.diagram = g.diagram();
    scene.notes = (0..g.below(2)).map(|_| Note::new(g.point(), g.words())).collect();
    scene
}

impl Generator<'_> {
    /// 0 to n − 1; 0 when the bytes are used up.
    pub fn below(&mut self, n: usize) -> usize {
        self.bytes.int_in_range(0..=n - 1).unwrap_or(0)
    }

    pub fn one_in(&mut self, n: usize) -> bool {
        self.below(n) == n - 1
    }

    /// 1 to n.
    pub fn count(&mut self, n: u32) -> u32 {
        1 + self.bytes.int_in_range(0..=n - 1).unwrap_or(0)
    }

    /// 0 to 1.
    pub fn unit(&mut self) -> f64 {
        f64::from(self.bytes.arbitrary::<u32>().unwrap_or(0)) / f64::from(u32::MAX)
    }

    pub fn between(&mut self, least: f64, most: f64) -> f64 {
        least + (most - least) * self.unit()
    }

    /// Now and then a number from the ends of the range, or beyond.
    fn extreme(&mut self, usual: f64) -> f64 {
        if !self.one_in(64) {
            return usual;
        }
        let far = [1e-12, 1e12, 1e-30, 1e30, 0.0, -0.0, 5e-324, 1e-300, 1e300, f64::NAN, f64::INFINITY];
        let size = match self.below(12) {
            11 => f64::from_bits(self.bytes.arbitrary().unwrap_or(0)),
            k => far[k],
        };
        if self.one_in(2) { -size } else { size }
    }

    /// The same number, or one so near that it is the question whether it is the same.
    fn beside(&mut self, x: f64) -> f64 {
        match self.below(6) {
            4 => [x.next_up(), x.next_down()][self.below(2)],
            5 => {
                let off = [1e-13, 1e-12, 1e-11, 1e-10, 1e-9, 1e-8, 1e-7, 1e-6, 1e-3][self.below(9)];
                x + [off, -off][self.below(2)] * self.scale
            }
            _ => x,
        }
    }

    fn coordinate(&mut self) -> f64 {
        let usual = match self.below(3) {
            0 => (self.below(11) as f64 - 5.0) * self.scale,
            1 => self.between(-10.0, 10.0) * self.scale,
            _ => {
                let p = self.known_point();
                let known = [p.x, p.y, -p.x, -p.y][self.below(4)];
                self.beside(known)
            }
        };
        self.extreme(usual)
    }

    fn known_point(&mut self) -> DVec2 {
        let k = self.below(self.points.len());
        self.points[k]
    }

    pub fn point(&mut self) -> DVec2 {
        let p = if self.one_in(3) {
            let known = self.known_point();
            DVec2::new(self.beside(known.x), self.beside(known.y))
        } else {
            DVec2::new(self.coordinate(), self.coordinate())
        };
        if p.is_finite() {
            self.points.push(p);
        }
        p
    }

    pub fn length(&mut self) -> f64 {
        let usual = match self.below(3) {
            0 => f64::from(self.count(6)) * self.scale,
            1 => self.between(0.1, 8.0) * self.scale,
            _ => {
                let k = self.below(self.lengths.len());
                self.beside(self.lengths[k])
            }
        };
        let length = self.extreme(usual);
        if length.is_finite() {
            self.lengths.push(length);
        }
        length
    }

    fn angle(&mut self) -> f64 {
        let usual = match self.below(3) {
            0 => 90.0 * (self.below(5) as f64 - 2.0),
            1 => [30.0, 45.0, 60.0, 1e-9, 360.0, -123.456, 1e6][self.below(7)],
            _ => self.between(-180.0, 180.0),
        };
        self.extreme(usual)
    }

    fn body(&mut self, k: usize) -> Body {
        let shape = self.shape();
        let is_open = matches!(shape, Shape::Flat { .. } | Shape::Arc { .. } | Shape::Stop { .. });
        let substance = match shape {
            Shape::LensGroup { .. } => Substance::Elements,
            _ if is_open || self.one_in(4) => Substance::Surface(self.surface(&shape)),
            _ => Substance::Medium(self.medium()),
        };
        let at = if self.one_in(2) { self.point() } else { DVec2::ZERO };
        let rotate = if self.one_in(3) { self.angle() } else { 0.0 };
        let label = self.one_in(6).then(|| self.words());
        let mut body = Body::new(shape, substance).placed(at, rotate);
        (body.name, body.label, body.color) = (self.name(k), label, self.color());
        body
    }

    fn surface(&mut self, shape: &Shape) -> Surface {
        let lens = matches!(shape, Shape::Flat { .. }) || self.one_in(64);
        match self.below(if lens { 5 } else { 4 }) {
            0 => Surface::Mirror,
            1 => Surface::Screen,
            2 => Surface::Absorber,
            3 => {
                let [reflect, transmit] = self.shares();
                Surface::BeamSplitter { reflect, transmit }
            }
            _ => Surface::ThinLens { focal_length: self.length() * [1.0, -1.0][self.below(2)] },
        }
    }

    /// Two shares, of 1 at most together.
    fn shares(&mut self) -> [f64; 2] {
        let first = [0.5, 0.0, 1.0, self.unit()][self.below(4)];
        let second = (1.0 - first) * [1.0, 0.0, self.unit()][self.below(3)];
        [first, self.extreme(second)]
    }

    pub fn medium(&mut self) -> Medium {
        match self.below(10) {
            0..=2 => Medium::Index(1.5),
            3 => Medium::Index(1.0),
            4 => {
                let n = [1.0 + f64::EPSILON, 1.0 + 1e-15, 1.33, 1.5 + 1e-12, 4.0, 1e6][self.below(6)];
                Medium::Index(self.extreme(n))
            }
            5 => Medium::Index(self.between(1.0, 2.5)),
            6 => Medium::Speed([2e8, 299_792_458.0, 1e3, self.between(1e8, 3e8)][self.below(4)]),
            7 => Medium::Cauchy((0..=self.below(3)).map(|k| [1.5, 0.004, 1e-5][k]).collect()),
            8 => {
                let b = [self.between(0.5, 1.5), 0.2, self.extreme(1.0)];
                Medium::Sellmeier { b, c: [0.006, 0.02, self.extreme(100.0)] }
            }
            _ => Medium::Catalog(["N-BK7", "water", "air", "N-SF11", "diamond", "glass"][self.below(6)].into()),
        }
    }

    fn name(&mut self, k: usize) -> Option<String> {
        let same = self.one_in(64);
        self.one_in(3).then(|| if same { "twin".into() } else { format!("{} {k}", self.words()) })
    }

    /// Plain words, and what other languages take for markup.
    fn words(&mut self) -> String {
        if !self.one_in(3) {
            return String::new();
        }
        let words = [
            "lens",
            "a longer name, with a comma",
            "<script>alert(1)</script>",
            "a & b \"c\" 'd' ]]> --",
            "=1+1",
            "\u{202e}right to left\u{0}\u{1b}[31m",
            "two\nlines\r\n\ttab",
            "$\\alpha_1$ % # {}",
            "θ₁ é 漢字 🔦 \u{fffe}",
            " ",
        ];
        words[self.below(words.len())].into()
    }

    fn color(&mut self) -> Option<[u8; 3]> {
        self.one_in(6).then(|| self.bytes.arbitrary().unwrap_or_default())
    }

    fn source(&mut self, k: usize) -> Source {
        let power = [1.0, 2.5, 1e-100, 1e100][if self.one_in(8) { self.below(4) } else { 0 }];
        let light = self.light();
        let polarization = [Polarization::Unpolarized, Polarization::S, Polarization::P][self.below(3)];
        let mut source = Source::new(light);
        (source.name, source.color) = (self.name(100 + k), self.color());
        source.spectrum = self.spectrum();
        (source.power, source.polarization) = (self.extreme(power), polarization);
        source
    }

    fn light(&mut self) -> Light {
        match self.below(6) {
            0 | 1 => Light::Ray { from: self.point(), direction: self.direction() },
            2 => Light::Beam {
                center: self.point(),
                direction: self.direction(),
                width: if self.one_in(8) { 0.0 } else { self.length() },
                rays: self.rays(),
            },
            3 => {
                let spread = [30.0, 0.0, 359.999, self.between(0.0, 360.0)][self.below(4)];
                Light::Fan { from: self.point(), direction: self.direction(), spread, rays: self.rays() }
            }
            4 => Light::Point { at: self.point(), rays: self.rays() },
            _ => Light::Object { from: self.point(), to: self.point() },
        }
    }

    fn rays(&mut self) -> u32 {
        let most = if self.one_in(16) { 70 } else { 6 };
        self.count(most)
    }

    fn direction(&mut self) -> Direction {
        if self.one_in(2) { Direction::Angle(self.angle()) } else { Direction::Towards(self.point()) }
    }

    fn spectrum(&mut self) -> Spectrum {
        match self.below(6) {
            4 => Spectrum::Lines([486.1327, 587.5618, 656.2725][..=self.below(3)].into()),
            5 => Spectrum::White { samples: self.count(8) },
            3 => Spectrum::Line([632.8, 420.0, 1000.0, self.between(350.0, 900.0)][self.below(4)]),
            _ => Spectrum::default(),
        }
    }

    fn trace(&mut self) -> TraceSettings {
        let secondary_rays = match self.below(5) {
            3 => SecondaryRays::TransmittedOnly,
            4 => {
                let [kr, kt] = self.shares();
                SecondaryRays::Fixed { kr, kt }
            }
            _ => SecondaryRays::Fresnel,
        };
        let max_depth = if self.one_in(16) { [32, 500, u32::MAX][self.below(3)] } else { self.count(8) };
        let min_power = [1e-3, 0.0, 0.1, 1e-12][self.below(4)];
        // Enough for few rays; now and then for so many that several threads share the work.
        let max_segments = if self.one_in(64) { 40_000 } else { [2000, 1, 7, 100][self.below(4)] };
        let mut trace = TraceSettings::default();
        trace.secondary_rays = secondary_rays;
        trace.max_depth = max_depth;
        trace.min_power = min_power;
        trace.max_segments = max_segments;
        trace
    }

    fn diagram(&mut self) -> DiagramSettings {
        let address = |g: &mut Self| ["0.0:", "0.0:t", "0.0:r", "0.0:tt", "1.0:", "nowhere"][g.below(6)].to_owned();
        let mut d = DiagramSettings::default();
        d.size = [[320, 200], [16, 16], [72, 54], [16_384, 16]][if self.one_in(3) { self.below(4) } else { 0 }];
        d.view = if self.one_in(6) { View::Box(self.point(), self.point()) } else { View::Auto };
        d.theme = [Theme::Light, Theme::Dark, Theme::Print][self.below(3)];
        d.color = [RayColor::Auto, RayColor::Wavelength, RayColor::Power, RayColor::Via][self.below(4)];
        d.faintest = [0.01, 0.0, 0.5, 1e-9][self.below(4)];
        d.deviations = (0..self.below(2)).map(|_| [address(self), address(self)]).collect();
        d.wavefronts = self.one_in(4).then(|| self.length());
        let switches = [
            &mut d.normals,
            &mut d.angles,
            &mut d.labels,
            &mut d.arrows,
            &mut d.legend,
            &mut d.extensions,
            &mut d.protractor,
            &mut d.optical_axis,
            &mut d.focal_points,
            &mut d.principal_planes,
            &mut d.grid,
            &mut d.scale_bar,
            &mut d.irradiance,
        ];
        for switch in switches {
            *switch ^= self.one_in(4);
        }
        d
    }
}
