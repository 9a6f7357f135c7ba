//! A scene from text to files.
