// Checks an engine's samples against a test vector:  check_vector VECTOR.txt SAMPLES STEP
// SAMPLES has a line `time x y angle` for the start and each step; what follows on a line and lines that begin with #
// are ignored. Exit code 0: right, 1: wrong, 2: cannot be used.  rustc -O check_vector.rs
use std::{env, fs, process::exit};
type Found<T> = Result<T, Box<dyn std::error::Error>>;
fn numbers(words: &mut dyn Iterator<Item = &str>, count: usize) -> Found<Vec<f64>> {
    let found = words.take(count).map(str::parse).collect::<Result<Vec<f64>, _>>()?;
    if found.len() == count { Ok(found) } else { Err("a line has too few numbers".into()) }
}
fn check(path: &str, samples: &str, step: f64) -> Found<bool> {
    let (vector, samples) = (fs::read_to_string(path)?, fs::read_to_string(samples)?);
    if vector.lines().next() != Some("tautline-vector-1") { return Err("not a tautline-vector-1".into()); }
    let mut samples = samples.lines().filter(|line| !line.starts_with('#') && !line.trim().is_empty()).map(|line| numbers(&mut line.split_whitespace(), 4));
    let (mut a, mut b) = (samples.next().ok_or("no samples")??, samples.next().ok_or("one sample")??);
    let (mut radius, mut fastest, mut worst, mut hit, mut asked) = (0.0, 0.0, 0.0_f64, 0.0, 0);
    for line in vector.lines() {
        let mut words = line.split_whitespace();
        let kind = words.next().unwrap_or("");
        if kind == "radius" { radius = numbers(&mut words, 1)?[0]; } else if kind == "fastest" { fastest = numbers(&mut words, 1)?[0]; }
        if !["sample", "impact", "taut", "slack"].contains(&kind) { continue; }
        let row = numbers(&mut words, 9)?; // time, x, y, angle, vx, vy, spin, growth, step
        if !(step <= row[8] * (1.0 + 1e-9)) { break; } // such a step cannot be judged here, nor later
        while b[0] < row[0] - 1e-9 * step {
            let next = match samples.next() { Some(next) => next, None => { println!("wrong: no sample at t = {} or later", row[0]); return Ok(false) } };
            (a, b) = (b, next?);
        }
        let (part, allowed) = (if b[0] > a[0] { ((row[0] - a[0]) / (b[0] - a[0])).min(1.0) } else { 1.0 }, 2.0 * step * fastest * row[7]);
        let by = |i: usize| a[i] + part * (b[i] - a[i]) - row[i];
        let off = by(1).hypot(by(2)).hypot(radius * by(3));
        if !(off <= allowed) { println!("wrong: at t = {} it is {off:.1e} m off, {allowed:.1e} m are allowed; the impact before is at t = {hit}", row[0]); return Ok(false); }
        (worst, asked, hit) = (worst.max(off / allowed), asked + 1, if kind == "impact" { row[0] } else { hit });
    }
    if asked < 2 { return Err("this step is too long for the vector".into()); }
    println!("right: {asked} rows asked, at worst {worst:.2} of what is allowed"); Ok(true)
}
fn main() {
    let words: Vec<String> = env::args().collect();
    let done = if words.len() == 4 { words[3].parse().map_err(Into::into).and_then(|step| check(&words[1], &words[2], step)) } else { Err("needs VECTOR.txt SAMPLES STEP".into()) };
    exit(match done { Ok(right) => i32::from(!right), Err(why) => { eprintln!("{why}"); 2 } })
}
