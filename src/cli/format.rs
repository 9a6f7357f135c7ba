//! `tissue fmt`.

use super::Exit;
use super::arguments::FmtOptions;
use crate::output::file::write_atomic;
use crate::scene::{FileSystem, Loader};
use crate::syntax::{self, Source};

/// Lays out files in the standard form.
pub fn format(options: &FmtOptions) -> Exit {
    let mut exit = Exit::Fine;
    for file in &options.files {
        let name = file.to_string_lossy().into_owned();
        let source = match FileSystem.load(&name) {
            Ok(text) => Source { name, text },
            Err(cause) => {
                tell!("error: cannot read {name}: {cause}");
                exit = Exit::WrongInput;
                continue;
            }
        };
        match syntax::format(&source) {
            Err(diagnostics) => {
                for diagnostic in diagnostics {
                    tell!("{}", diagnostic.render(&source));
                }
                exit = Exit::WrongInput;
            }
            Ok(text) if text == source.text => {}
            Ok(_) if options.check => {
                say!("{}: not in the standard form", source.name);
                if exit == Exit::Fine {
                    exit = Exit::Failed;
                }
            }
            Ok(text) => {
                if let Err(cause) = write_atomic(file, text.as_bytes()) {
                    tell!("error: cannot write {}: {cause}", source.name);
                    exit = Exit::WrongInput;
                }
            }
        }
    }
    exit
}
