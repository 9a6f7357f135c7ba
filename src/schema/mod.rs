//! How a physical block declares its words.
