use clap::Args;

use crate::scene::{Limit, Limits, nearest};

/// How much a scene may take.
#[derive(Args)]
pub(super) struct Allowance {
    /// Let a scene take more of something, such as 'rays=20000000', or less; may be given several times. The names:
    /// bytes, bodies, points, sides, sources, objects, rays, lines, indices, segments, pixels, notes, deviations, letters.
    #[arg(long = "limit", value_name = "NAME=N", value_parser = limit)]
    given: Vec<(Limit, u64)>,
}

impl Allowance {
    /// The usual limits with those that were given in their places; of two for the same, the last counts.
    pub(super) fn limits(&self) -> Limits {
        self.given.iter().fold(Limits::default(), |limits, (limit, most)| limits.with(*limit, *most))
    }
}

fn limit(argument: &str) -> Result<(Limit, u64), String> {
    let (name, number) = argument.split_once('=').ok_or("a name and a number are needed, such as rays=20000000")?;
    let limit = Limit::ALL.into_iter().find(|limit| limit.name() == name).ok_or_else(|| unknown(name))?;
    let is_plain = number.bytes().all(|byte| byte.is_ascii_digit());
    let most = number.parse().ok().filter(|most| is_plain && (1..=limit.highest()).contains(most));
    Ok((limit, most.ok_or_else(|| format!("a whole number from 1 to {} is needed", limit.highest()))?))
}

fn unknown(name: &str) -> String {
    let names = Limit::ALL.map(Limit::name);
    let near = nearest(name, &names).map_or(String::new(), |near| format!("did you mean '{near}'? "));
    format!("{near}the limits are {}", names.join(", "))
}
