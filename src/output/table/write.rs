//! A table as CSV, at once or row by row while a run proceeds.
//!
//! Owns the text form: `#` lines with provenance and the meaning of every column, one line of names,
//! one line a row, numbers in the shortest form that reads back to the same bits.

use std::io::Write;

use super::model::{Table, TableColumn, TableError};

/// Shortest decimal form that reads back to the same bits: `0.1`, `1e-7`, `-0`, `3`.
pub fn number(value: f64) -> String {
    let text = format!("{value:?}");
    match text.strip_suffix(".0") {
        Some(whole) => whole.to_owned(),
        None => text,
    }
}

impl Table {
    /// The table as CSV.
    ///
    /// # Errors
    /// [`TableError::DuplicateColumn`], [`TableError::Ragged`], [`TableError::NotFinite`].
    pub fn to_csv(&self) -> Result<String, TableError> {
        let mut bytes = Vec::new();
        TableWriter::new(&mut bytes, self)?;
        Ok(String::from_utf8(bytes).expect("the writer writes strings only"))
    }

    fn head(&self) -> Result<String, TableError> {
        for (i, column) in self.columns.iter().enumerate() {
            if self.columns[..i].iter().any(|other| other.name == column.name) {
                let (table, column) = (self.name.clone(), column.name.clone());
                return Err(TableError::DuplicateColumn { table, column });
            }
        }
        let mut text = String::new();
        for line in self.provenance.iter().flat_map(|line| line.lines()) {
            text.push_str(&format!("# {line}\n"));
        }
        text.push_str(&format!("# table {}\n", one_line(&self.name)));
        for TableColumn { name, unit, text: meaning } in &self.columns {
            let unit = if unit.is_empty() { "1" } else { unit };
            let line = format!("# column {name} [{unit}] {}", one_line(meaning));
            text.push_str(line.trim_end());
            text.push('\n');
        }
        let names: Vec<String> = self.columns.iter().map(|column| quoted(&column.name)).collect();
        text.push_str(&names.join(","));
        text.push('\n');
        Ok(text)
    }
}

/// A name as one CSV field.
fn quoted(name: &str) -> String {
    if name.contains([',', '"', '\n', '\r', '#']) {
        format!("\"{}\"", name.replace('"', "\"\""))
    } else {
        name.to_owned()
    }
}

/// A description without line breaks, which would end its `#` line.
fn one_line(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// Writes a table while it grows; every row is flushed, so an interrupted run leaves a readable file.
#[derive(Debug)]
pub struct TableWriter<W: Write> {
    sink: W,
    name: String,
    columns: Vec<String>,
    rows: u64,
}

impl<W: Write> TableWriter<W> {
    /// Writes the head and the rows `table` already has.
    ///
    /// # Errors
    /// As [`Table::to_csv`], and [`TableError::Io`] from `sink`.
    pub fn new(sink: W, table: &Table) -> Result<Self, TableError> {
        let columns = table.columns.iter().map(|column| column.name.clone()).collect();
        let head = table.head()?;
        let mut writer = Self { sink, name: table.name.clone(), columns, rows: 0 };
        writer.write(&head)?;
        for row in &table.rows {
            writer.append(row)?;
        }
        Ok(writer)
    }

    /// Writes one row and flushes it.
    ///
    /// # Errors
    /// [`TableError::Ragged`] and [`TableError::NotFinite`], in which case nothing is written, and
    /// [`TableError::Io`] from the sink.
    pub fn append(&mut self, row: &[f64]) -> Result<(), TableError> {
        self.rows += 1;
        let (found, required) = (row.len(), self.columns.len());
        if found != required {
            return Err(TableError::Ragged { table: self.name.clone(), line: self.rows, found, required });
        }
        if let Some(bad) = row.iter().position(|value| !value.is_finite()) {
            let (table, column) = (self.name.clone(), self.columns[bad].clone());
            return Err(TableError::NotFinite { table, column, at: row[0], value: row[bad] });
        }
        let values: Vec<String> = row.iter().copied().map(number).collect();
        self.write(&format!("{}\n", values.join(",")))
    }

    /// One `write` for the whole text, so that a line is not torn by an interruption between calls.
    fn write(&mut self, text: &str) -> Result<(), TableError> {
        let written = self.sink.write_all(text.as_bytes()).and_then(|()| self.sink.flush());
        written.map_err(|cause| TableError::Io { table: self.name.clone(), cause })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn pull() -> Table {
        Table {
            name: "pull".into(),
            columns: vec![
                TableColumn::new("t", "s", "time"),
                TableColumn::new("d", "m", "2*displacement(\n  strip.xmax).x"),
                TableColumn::new("r", "", ""),
            ],
            rows: vec![vec![0.0, -0.0, 1.0], vec![3e-5, 1e-7, 1.0 / 3.0]],
            provenance: vec!["tissue 0.1.0".into(), "input a.tissue".into()],
        }
    }

    #[test]
    fn a_table_heads_its_rows_with_provenance_units_and_meaning() {
        insta::assert_snapshot!(pull().to_csv().expect("finite"));
    }

    #[test]
    fn a_row_that_is_not_finite_or_not_full_is_refused_and_not_written() {
        let mut table = pull();
        let mut bytes = Vec::new();
        let mut writer = TableWriter::new(&mut bytes, &table).expect("finite");
        let error = writer.append(&[6e-5, f64::NAN, 1.0]).expect_err("not a number");
        assert_eq!(error.to_string(), "table `pull`: column `d` is NaN in the row that starts with 6e-5");
        let error = writer.append(&[6e-5, 1.0]).expect_err("short");
        assert_eq!(error.to_string(), "table `pull`, line 4: 2 values for 3 columns");
        assert_eq!(String::from_utf8(bytes).expect("text"), table.to_csv().expect("finite"));
        table.columns[1].name = "t".into();
        let error = table.to_csv().expect_err("two of one name");
        assert_eq!(error.to_string(), "table `pull`: two columns are named `t`");
    }

    #[test]
    fn every_row_is_flushed_when_appended() {
        /// Counts the bytes that reached it after the last flush.
        struct Sink(usize);
        impl Write for Sink {
            fn write(&mut self, bytes: &[u8]) -> std::io::Result<usize> {
                self.0 += bytes.len();
                Ok(bytes.len())
            }
            fn flush(&mut self) -> std::io::Result<()> {
                self.0 = 0;
                Ok(())
            }
        }
        let mut writer = TableWriter::new(Sink(0), &pull()).expect("finite");
        assert_eq!(writer.sink.0, 0);
        writer.append(&[1.0, 2.0, 3.0]).expect("finite");
        assert_eq!(writer.sink.0, 0);
    }

    proptest! {
        #[test]
        fn numbers_read_back_to_the_same_bits(value in prop::num::f64::NORMAL | prop::num::f64::SUBNORMAL | prop::num::f64::ZERO) {
            let text = number(value);
            prop_assert_eq!(text.parse::<f64>().expect("a number").to_bits(), value.to_bits());
            prop_assert!(text.len() <= 24);
        }
    }
}
