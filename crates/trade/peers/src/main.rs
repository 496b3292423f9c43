//! Ombra against the crates that do the same work, side by side: `cargo peers`, from the root of the repository.

mod measured;
mod race;
mod random;
mod rows;

use std::process::ExitCode;

use clap::Parser;

use measured::Measured;
use race::Rounds;
use rows::Row;

/// Measures Ombra against the crates that do the same work, each row in interleaved rounds.
#[derive(Parser)]
#[command(name = "cargo peers")]
struct Arguments {
    /// Rows to run: those whose name contains one of these; none given: all
    rows: Vec<String>,
    /// Fewer and shorter rounds: to see that everything runs, not to compare
    #[arg(long)]
    quick: bool,
    /// One line of JSON for each row instead of the tables
    #[arg(long)]
    json: bool,
    /// Names of the rows
    #[arg(long)]
    list: bool,
    /// Rounds [default: 31, with --quick 3]
    #[arg(long, value_parser = clap::value_parser!(u16).range(1..))]
    rounds: Option<u16>,
    /// Not for people: be the process in which llvmpipe draws this form of the triangles
    #[arg(long, hide = true)]
    llvmpipe: Option<rows::triangles::Form>,
}

fn main() -> ExitCode {
    let arguments = Arguments::parse();
    if let Some(form) = arguments.llvmpipe {
        settle_allocator();
        return match rows::triangles::llvmpipe::serve(form) {
            Ok(()) => ExitCode::SUCCESS,
            Err(error) => {
                eprintln!("llvmpipe's process failed: {error}");
                ExitCode::FAILURE
            }
        };
    }
    let rows = match chosen(&arguments.rows) {
        Ok(rows) => rows,
        Err(sentence) => {
            eprintln!("{sentence}");
            return ExitCode::from(2);
        }
    };
    if arguments.list {
        rows.iter().for_each(|row| println!("{}", row.name));
        return ExitCode::SUCCESS;
    }
    let (number, least_seconds) = if arguments.quick {
        (3, 1e-3)
    } else {
        (31, 5e-3)
    };
    let rounds = Rounds {
        number: arguments.rounds.map_or(number, usize::from),
        least_seconds,
    };
    settle_allocator();
    let mut all_same = true;
    let mut missed = Vec::new();
    for row in rows {
        let measured = (row.measure)(row.name, rounds);
        if arguments.json {
            println!("{}", measured.json());
        } else {
            println!("{measured}");
        }
        for impostor in measured.impostors() {
            eprintln!("{}: {} did not do the same work", row.name, impostor.name);
            all_same = false;
        }
        missed.extend(missed_goals(&measured));
    }
    if !arguments.json {
        match missed.as_slice() {
            [] => println!("everything reached"),
            missed => println!("not reached:\n  {}", missed.join("\n  ")),
        }
    }
    if all_same {
        ExitCode::SUCCESS
    } else {
        ExitCode::FAILURE
    }
}

/// Lets large blocks come from memory that is already there. Some allocators ask the system for each, and touch it page by
/// page, until one as large has been given back: rows would depend on what ran before them.
fn settle_allocator() {
    drop(std::hint::black_box(vec![0_u8; 30 << 20]));
}

/// The rows asked for, or a sentence about a name that no row has.
fn chosen(names: &[String]) -> Result<Vec<Row>, String> {
    let all = rows::all();
    let unknown = (names.iter()).find(|name| !all.iter().any(|row| row.name.contains(*name)));
    if let Some(unknown) = unknown {
        let known: Vec<&str> = all.iter().map(|row| row.name).collect();
        let known = known.join(", ");
        return Err(format!(
            "no row's name contains \"{unknown}\"; there are {known}"
        ));
    }
    let asked = |row: &Row| names.is_empty() || names.iter().any(|n| row.name.contains(n));
    Ok(all.into_iter().filter(asked).collect())
}

fn missed_goals(measured: &Measured) -> impl Iterator<Item = String> {
    (measured.verdicts.iter())
        .filter(|verdict| !verdict.reached)
        .map(|verdict| format!("{}: {verdict}", measured.row))
}
