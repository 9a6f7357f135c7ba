//! Ctrl-C: a running scene is told to stop; whatever else runs ends at once.

use std::sync::atomic::{AtomicBool, Ordering};

/// Whether a scene is running that looks for [`is_interrupted`].
static LISTENED: AtomicBool = AtomicBool::new(false);

/// Whether Ctrl-C has been pressed.
static PRESSED: AtomicBool = AtomicBool::new(false);

/// The exit code of an interrupted run, 128 and the number of the signal as shells count it.
pub const CODE: u8 = 130;

/// Lets Ctrl-C stop the scene that is about to run, after the step under way. Pressed a second time, or when no
/// scene runs, it ends the program.
pub fn listen() {
    let handler = || {
        if !LISTENED.load(Ordering::SeqCst) || PRESSED.swap(true, Ordering::SeqCst) {
            std::process::exit(i32::from(CODE));
        }
    };
    // Set before already, or refused by the system: then the system's own way stays.
    let _ = ctrlc::set_handler(handler);
    LISTENED.store(true, Ordering::SeqCst);
}

/// No scene runs any more.
pub fn leave() {
    LISTENED.store(false, Ordering::SeqCst);
}

/// Whether the scene is to stop.
pub fn is_interrupted() -> bool {
    PRESSED.load(Ordering::SeqCst)
}
