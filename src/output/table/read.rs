//! CSV back into a table: our own files and reference tables of other programs.
//!
//! Owns reading only; what a column means is taken from the head where it says so.

use super::model::{Table, TableColumn, TableError};

impl Table {
    /// Reads a table from the text of a CSV file.
    ///
    /// Lines that start with `#` are provenance, except `# column name [unit] text`, which describes
    /// a column. The first other line names the columns. `nan` and `inf` are read as such, since
    /// reference tables hold them.
    ///
    /// # Errors
    /// [`TableError::NoHeader`], [`TableError::Ragged`], [`TableError::NotANumber`],
    /// [`TableError::DuplicateColumn`], [`TableError::Malformed`]: the first fault, by line.
    pub fn parse(name: &str, text: &str) -> Result<Self, TableError> {
        let table = || name.to_owned();
        let mut reader = csv::ReaderBuilder::new()
            .comment(Some(b'#'))
            .has_headers(false)
            .flexible(true)
            .trim(csv::Trim::All)
            .from_reader(text.as_bytes());
        let mut records = reader.records();
        let header = match records.next() {
            None => return Err(TableError::NoHeader { table: table() }),
            Some(record) => record.map_err(|cause| TableError::Malformed { table: table(), cause })?,
        };
        let (provenance, described) = head(text);
        let mut columns: Vec<TableColumn> = Vec::with_capacity(header.len());
        for field in &header {
            if columns.iter().any(|column| column.name == field) {
                return Err(TableError::DuplicateColumn { table: table(), column: field.into() });
            }
            let known = described.iter().find(|column| column.name == field);
            columns.push(known.cloned().unwrap_or_else(|| TableColumn::new(field, "", "")));
        }
        let mut rows = Vec::new();
        for record in records {
            let record = record.map_err(|cause| TableError::Malformed { table: table(), cause })?;
            let line = record.position().map_or(0, csv::Position::line);
            let (found, required) = (record.len(), columns.len());
            if found != required {
                return Err(TableError::Ragged { table: table(), line, found, required });
            }
            let mut row = Vec::with_capacity(required);
            for (field, column) in record.iter().zip(&columns) {
                row.push(field.parse::<f64>().map_err(|_| TableError::NotANumber {
                    table: table(),
                    column: column.name.clone(),
                    line,
                    found: field.to_owned(),
                })?);
            }
            rows.push(row);
        }
        Ok(Self { name: table(), columns, rows, provenance })
    }
}

/// The provenance lines and the described columns at the head of `text`.
fn head(text: &str) -> (Vec<String>, Vec<TableColumn>) {
    let (mut provenance, mut columns) = (Vec::new(), Vec::new());
    let lines = text.lines().take_while(|line| line.starts_with('#') || line.trim().is_empty());
    for line in lines.filter_map(|line| line.strip_prefix('#')).map(str::trim) {
        match line.strip_prefix("column ").and_then(described) {
            Some(column) => columns.push(column),
            None if line.starts_with("table ") => {}
            None => provenance.push(line.to_owned()),
        }
    }
    (provenance, columns)
}

/// `name [unit] text` as a column; the unit `1` is a number's.
fn described(line: &str) -> Option<TableColumn> {
    let (name, rest) = line.split_once(" [")?;
    let (unit, text) = rest.split_once(']')?;
    Some(TableColumn::new(name.trim(), if unit == "1" { "" } else { unit }, text.trim()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_written_table_reads_back_equal() {
        let table = Table {
            name: "pull".into(),
            columns: vec![TableColumn::new("t", "s", "time"), TableColumn::new("a,b", "", "a \"ratio\"")],
            rows: vec![vec![0.0, 1e-300], vec![0.1, -1.0 / 3.0]],
            provenance: vec!["tissue 0.1.0".into(), "input specs/a b.tissue".into()],
        };
        let text = table.to_csv().expect("finite");
        assert_eq!(Table::parse("pull", &text).expect("our own"), table);
    }

    #[test]
    fn a_reference_table_of_another_program_reads_with_its_first_and_last_rows() {
        let path = "verification/references/fe_artery_axial_k0.226_D1e-7_Q2P1_28x10x3g.csv";
        let text = std::fs::read_to_string(path).expect("the reference is in the repository");
        let table = Table::parse("fe", &text).expect("a table");
        assert_eq!((table.columns.len(), table.rows.len()), (26, 9));
        assert_eq!(table.column("end_disp_mm").expect("named")[8], 2.0);
        assert_eq!(table.column("force_N").expect("named")[8], 1.945034672);
        assert!(table.column("Fy_N").expect("named").iter().all(|value| value.is_nan()));
        assert!(table.provenance[0].starts_with("strip artery orient=axial"));
        assert_eq!(table.column("force"), None);
    }

    #[test]
    fn each_fault_names_its_line_and_what_was_found() {
        let fault = |text: &str| Table::parse("x", text).expect_err("faulty").to_string();
        assert_eq!(fault("# only a comment\n"), "table `x` has no line that names its columns");
        assert_eq!(fault("# c\na,b\n1,2\n3\n"), "table `x`, line 4: 1 values for 2 columns");
        assert_eq!(fault("a,b\n1,two\n"), "table `x`, line 2: `two` in column `b` is not a number");
        assert_eq!(fault("a,a\n1,2\n"), "table `x`: two columns are named `a`");
    }
}
