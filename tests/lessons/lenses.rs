//! Scenes of `scenes/lenses`.

use crate::Lesson;

#[path = "lenses/aberrations.rs"]
mod aberrations;
#[path = "lenses/ideal.rs"]
mod ideal;
#[path = "lenses/singlets.rs"]
mod singlets;
#[path = "lenses/systems.rs"]
mod systems;

pub(crate) const LESSONS: &[Lesson] = &[
    ("lenses/achromat", aberrations::the_achromat_joins_the_colors_that_the_singlet_spreads),
    ("lenses/air-in-water", singlets::an_air_lens_in_water_spreads_what_a_glass_one_gathers),
    ("lenses/ball", singlets::a_ball_focuses_by_its_closed_form),
    ("lenses/beam-expander", systems::the_beam_leaves_parallel_and_three_times_as_wide),
    ("lenses/biconcave", singlets::a_biconcave_lens_has_a_virtual_focus),
    ("lenses/biconvex", singlets::a_biconvex_lens_focuses_where_the_lensmaker_says),
    ("lenses/caustic-on-screen", aberrations::the_screen_is_brightest_where_it_cuts_the_caustic),
    ("lenses/chromatic-aberration", aberrations::blue_crosses_before_red),
    ("lenses/cooke-triplet", systems::three_fields_pass_the_stop_and_are_sharp),
    ("lenses/depth-of-field", systems::only_the_far_point_is_sharp_on_the_film),
    ("lenses/diverging", ideal::a_diverging_lens_makes_a_small_virtual_image),
    ("lenses/facets", aberrations::facets_bring_strips_not_a_focus),
    ("lenses/galilean-telescope", systems::galileo_turns_light_four_times_as_far),
    ("lenses/intermediate-image", systems::the_second_lens_images_the_first_image),
    ("lenses/kepler-telescope", systems::kepler_turns_light_four_times_as_far_to_the_other_side),
    ("lenses/magnifier", ideal::a_magnifier_makes_a_large_virtual_image),
    ("lenses/meniscus", singlets::the_thick_middle_gathers_and_the_thin_one_spreads),
    ("lenses/plano-convex", aberrations::the_curved_face_first_is_four_times_better),
    ("lenses/principal-rays", ideal::three_principal_rays_meet_in_the_image),
    ("lenses/relay", systems::a_relay_images_upside_down_by_the_ratio_of_focal_lengths),
    ("lenses/spherical-aberration", aberrations::rim_rays_cross_earlier),
    ("lenses/wavefronts", singlets::all_ways_to_the_focus_take_equally_long),
    ("lenses/thick-lens", systems::distances_count_from_the_principal_planes),
];
