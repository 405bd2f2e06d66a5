//! The bouncing ball from Rust, without a crate.
use std::os::raw::{c_char, c_void};

#[link(name = "tautline")]
extern "C" {
    fn tautline_case_from_text(text: *const u8, length: usize, name: *const c_char) -> *mut c_void;
    fn tautline_solve(case: *const c_void, options: *const c_void, to: *mut *mut c_void) -> i32;
    fn tautline_states(m: *const c_void, times: *const f64, count: usize, states: *mut f64,
                       taut: *mut i32, wrong: *mut usize) -> i32;
    fn tautline_motion_free(motion: *mut c_void);
    fn tautline_case_free(case: *mut c_void);
}

const BALL: &str = "name = 'ball'\nduration = 10.0\ngravity = [0, -1]\nbody = {mass = 1, inertia = 0.4}
initial = {position = [0, 0.5]}
[[cables]]\nanchor = [0, 2]\nattachment = [0, 0]\nlength = 2\nrestitution = 0.5\n";

fn main() {
    let times = [0.5, 1.0, 1.5, 2.25, 9.0];
    let heights = [0.375, 0.0, 0.125, 0.03125, 0.0]; // exact: dyadic numbers
    let mut states = [[0.0f64; 6]; 5];
    let mut taut = [-1i32; 5];
    let mut motion = std::ptr::null_mut();
    unsafe {
        let case = tautline_case_from_text(BALL.as_ptr(), BALL.len(), std::ptr::null());
        assert_eq!(tautline_solve(case, std::ptr::null(), &mut motion), 0);
        let status = tautline_states(motion, times.as_ptr(), times.len(), states[0].as_mut_ptr(),
                                     taut.as_mut_ptr(), std::ptr::null_mut());
        assert_eq!(status, 0);
        tautline_motion_free(motion);
        tautline_case_free(case);
    }
    assert_eq!(states.map(|state| state[1]), heights);
    assert_eq!(states.map(|state| state[4]), [-0.5, 0.5, 0.0, 0.0, 0.0]);
    assert_eq!(taut, [0, 0, 0, 0, 1]);
    println!("right");
}
