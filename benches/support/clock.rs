use std::time::Instant;

/// Median seconds of every task, the tasks run in turns, so that a slow minute of the machine slows them all alike.
pub(crate) fn medians(rounds: usize, tasks: &mut [Box<dyn FnMut() + '_>]) -> Vec<f64> {
    let mut times = vec![Vec::new(); tasks.len()];
    for round in 0..rounds {
        for turn in 0..tasks.len() {
            // Each round begins with another task.
            let k = (turn + round) % tasks.len();
            let start = Instant::now();
            tasks[k]();
            times[k].push(start.elapsed().as_secs_f64());
        }
    }
    times.iter_mut().map(|times| median(times)).collect()
}

pub(crate) fn median(values: &mut [f64]) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}
