//! A race: the limit, the peers and ours do the same work in turns, and are compared round by round.

use std::hint::black_box;
use std::time::Instant;

use cpu_time::{ProcessTime, ThreadTime};

use crate::measured::{Against, Entry, Goal, Measured, Role, Shown, Spread, Verdict};

/// What the contestants of a race write to. Each starts from the same memory, cleared.
pub trait Scene {
    /// Undoes what a contestant did.
    fn clear(&mut self);
    /// Numbers that show what a contestant did.
    fn shows(&self) -> Vec<Shown>;
}

/// How often and how long to measure.
#[derive(Clone, Copy, Debug)]
pub struct Rounds {
    pub number: usize,
    /// Least processor time of one measurement, in seconds; the work is repeated until it takes that long.
    pub least_seconds: f64,
}

/// What is taken for the time of the work.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Clock {
    /// Processor time of the thread that runs the race.
    Thread,
    /// Processor time of all threads of the process: of contestants that may start some, but keep one busy at a time.
    Process,
    /// What a watch shows: of contestants that keep several busy.
    Wall,
}

impl Clock {
    /// Seconds that `run` takes.
    pub fn time(self, run: impl FnOnce()) -> f64 {
        match self {
            Self::Thread => {
                let start = ThreadTime::now();
                run();
                start.elapsed().as_secs_f64()
            }
            Self::Process => {
                let start = ProcessTime::now();
                run();
                start.elapsed().as_secs_f64()
            }
            Self::Wall => {
                let start = Instant::now();
                run();
                start.elapsed().as_secs_f64()
            }
        }
    }
}

/// A contestant that runs in another process, and measures itself there.
pub trait Elsewhere<S> {
    /// Seconds that it took to do the work so often, all in all; NaN where it failed.
    fn seconds(&mut self, repeats: u32) -> f64;
    /// Brings what it did into the scene.
    fn hand_in(&mut self, scene: &mut S);
}

/// A peer that takes longer for the work, in seconds, does it once and not in each round.
const PATIENCE: f64 = 0.5;

enum Pace {
    /// So often in each measurement.
    Repeated(u32),
    /// Once in all, in so many seconds.
    Once(f64),
}

enum Work<'a, S> {
    Here(Box<dyn FnMut(&mut S) + 'a>),
    Elsewhere(Box<dyn Elsewhere<S> + 'a>),
}

struct Contestant<'a, S> {
    name: String,
    role: Role,
    work: Work<'a, S>,
    clock: Clock,
    pace: Pace,
    shown: Vec<Shown>,
    seconds: Vec<f64>,
}

/// Names the work, the limit, the peers and ours, and [runs](Race::run) them.
pub struct Race<'a, S> {
    row: String,
    work: String,
    items: f64,
    unit: &'static str,
    scene: S,
    clock: Clock,
    contestants: Vec<Contestant<'a, S>>,
    goals: Vec<(String, Goal)>,
    notes: Vec<String>,
}

impl<'a, S: Scene> Race<'a, S> {
    /// `items` of `unit` are done by each contestant; throughput is counted in them.
    pub fn new(row: &str, work: String, items: f64, unit: &'static str, scene: S) -> Self {
        Self {
            row: row.to_owned(),
            work,
            items,
            unit,
            scene,
            clock: Clock::Thread,
            contestants: Vec::new(),
            goals: Vec::new(),
            notes: Vec::new(),
        }
    }

    /// Another clock for those who enter from now on.
    pub fn clock(mut self, clock: Clock) -> Self {
        self.clock = clock;
        self
    }

    /// What no contestant can beat: the same memory traffic without the work.
    pub fn limit(self, name: &str, run: impl FnMut(&mut S) + 'a) -> Self {
        self.enter(name, Role::Limit, Work::Here(Box::new(run)))
    }

    pub fn peer(self, name: &str, run: impl FnMut(&mut S) + 'a) -> Self {
        self.enter(name, Role::Peer { fault: None }, Work::Here(Box::new(run)))
    }

    /// A peer in a process of its own.
    pub fn peer_elsewhere(self, name: &str, peer: impl Elsewhere<S> + 'a) -> Self {
        let work = Work::Elsewhere(Box::new(peer));
        self.enter(name, Role::Peer { fault: None }, work)
    }

    /// A peer whose results were checked, with what was found wrong. It runs, but is not one to be measured against.
    pub fn checked_peer(
        self,
        name: &str,
        fault: Option<String>,
        run: impl FnMut(&mut S) + 'a,
    ) -> Self {
        self.enter(name, Role::Peer { fault }, Work::Here(Box::new(run)))
    }

    /// Ours, and what it has to reach.
    pub fn ours(mut self, name: &str, goals: &[Goal], run: impl FnMut(&mut S) + 'a) -> Self {
        (self.goals).extend(goals.iter().map(|&goal| (name.to_owned(), goal)));
        self.enter(name, Role::Ours, Work::Here(Box::new(run)))
    }

    /// A line below the table.
    pub fn note(mut self, note: String) -> Self {
        self.notes.push(note);
        self
    }

    fn enter(mut self, name: &str, role: Role, work: Work<'a, S>) -> Self {
        self.contestants.push(Contestant {
            name: name.to_owned(),
            role,
            work,
            clock: self.clock,
            pace: Pace::Repeated(1),
            shown: Vec::new(),
            seconds: Vec::new(),
        });
        self
    }

    /// Measures: in each round the limit first, then the others, starting with another one each time.
    pub fn run(mut self, rounds: Rounds) -> Measured {
        let Self {
            contestants, scene, ..
        } = &mut self;
        for contestant in contestants.iter_mut() {
            contestant.warm_up(scene, rounds.least_seconds);
        }
        let (limits, mut others): (Vec<_>, Vec<_>) =
            (contestants.iter_mut()).partition(|c| c.role == Role::Limit);
        let mut limits = limits;
        for _ in 0..rounds.number {
            for contestant in limits.iter_mut().chain(&mut others) {
                let seconds = contestant.time(scene);
                contestant.seconds.push(seconds);
            }
            if !others.is_empty() {
                others.rotate_left(1);
            }
        }
        self.measured(rounds)
    }

    fn measured(self, rounds: Rounds) -> Measured {
        let all = &self.contestants;
        let of = |role: &Role| all.iter().find(|c| c.role == *role);
        let reference = of(&Role::Ours);
        let entries: Vec<Entry> = (all.iter())
            .map(|c| Entry {
                name: c.name.clone(),
                role: c.role.clone(),
                throughput: self.items / Spread::of(c.seconds.iter().copied()).median,
                of_limit: of(&Role::Limit).map(|limit| c.speed_over(limit)),
                ours_over_it: (all.iter())
                    .filter(|ours| ours.role == Role::Ours && c.role != Role::Limit)
                    .map(|ours| (ours.name.clone(), ours.speed_over(c)))
                    .collect(),
                same_work: c.role == Role::Limit
                    || reference.is_none_or(|reference| Shown::agree(&c.shown, &reference.shown)),
                once: matches!(c.pace, Pace::Once(_)),
                shown: c.shown.clone(),
            })
            .collect();
        let verdicts = (self.goals.iter())
            .filter_map(|(name, goal)| {
                let ours = all.iter().find(|c| c.name == *name)?;
                let rival = self.rival(&entries, goal.against)?;
                let ratio = ours.speed_over(rival);
                Some(Verdict {
                    ours: name.clone(),
                    goal: *goal,
                    rival: rival.name.clone(),
                    ratio,
                    reached: ratio.median >= goal.at_least,
                })
            })
            .collect();
        Measured {
            row: self.row,
            work: self.work,
            unit: self.unit,
            items: self.items,
            rounds: rounds.number,
            entries,
            verdicts,
            notes: self.notes,
        }
    }

    /// The contestant that a goal is about.
    fn rival(&self, entries: &[Entry], against: Against) -> Option<&Contestant<'a, S>> {
        let is_rival = |entry: &Entry| match (&entry.role, against) {
            (Role::Limit, Against::Limit) => true,
            (Role::Peer { fault }, Against::FastestPeer) => fault.is_none() && entry.same_work,
            (Role::Peer { .. }, Against::AnyPeer) => true,
            (Role::Peer { .. }, Against::Peer(name)) => entry.name == name,
            _ => false,
        };
        (self.contestants.iter().zip(entries))
            .filter(|(_, entry)| is_rival(entry))
            .max_by(|(_, a), (_, b)| a.throughput.total_cmp(&b.throughput))
            .map(|(contestant, _)| contestant)
    }
}

impl<S: Scene> Contestant<'_, S> {
    /// Runs once to see what it does, and again to see how long that takes.
    fn warm_up(&mut self, scene: &mut S, least_seconds: f64) {
        let first = self.time(scene);
        if let Work::Elsewhere(peer) = &mut self.work {
            peer.hand_in(scene);
        }
        self.shown = scene.shows();
        if first > PATIENCE {
            self.pace = Pace::Once(first);
        } else {
            let again = self.time(scene).max(1e-9);
            self.pace = Pace::Repeated((least_seconds / again).ceil().clamp(1.0, 1e6) as u32);
        }
    }

    /// Seconds for the work done once.
    fn time(&mut self, scene: &mut S) -> f64 {
        let repeats = match self.pace {
            Pace::Repeated(repeats) => repeats,
            Pace::Once(seconds) => return seconds,
        };
        scene.clear();
        let seconds = match &mut self.work {
            Work::Here(run) => self.clock.time(|| {
                for _ in 0..repeats {
                    run(black_box(scene));
                }
            }),
            Work::Elsewhere(peer) => peer.seconds(repeats),
        };
        seconds / f64::from(repeats)
    }

    /// How many times as fast as `other`, round by round.
    fn speed_over(&self, other: &Self) -> Spread {
        Spread::of((self.seconds.iter().zip(&other.seconds)).map(|(own, its)| its / own))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Counts up to what it is told.
    struct Sum(f64);

    impl Scene for Sum {
        fn clear(&mut self) {
            self.0 = 0.0;
        }

        fn shows(&self) -> Vec<Shown> {
            vec![Shown {
                name: "sum",
                value: self.0,
                within: Some(0.0),
            }]
        }
    }

    fn add(to: u32) -> impl FnMut(&mut Sum) {
        move |sum| sum.0 = (1..=to).fold(0.0, |all, i| black_box(all + f64::from(i)))
    }

    #[test]
    fn a_goal_is_held_against_the_right_rival() {
        let goal = |against| Goal {
            at_least: 1.0,
            against,
        };
        let goals = [
            Against::FastestPeer,
            Against::AnyPeer,
            Against::Peer("slow"),
            Against::Limit,
        ];
        let rounds = Rounds {
            number: 5,
            least_seconds: 1e-3,
        };
        let fault = Some("it stops early".to_owned());
        let measured = Race::new("sums", "sums".to_owned(), 1.0, "sum", Sum(0.0))
            .limit("nothing", |_: &mut Sum| {})
            .peer("slow", |sum| (0..10).for_each(|_| add(1000)(sum)))
            .peer("another sum", add(10))
            .checked_peer("wrong", fault, add(20))
            .ours("ours", &goals.map(goal), add(1000))
            .run(rounds);
        let found: Vec<_> = (measured.verdicts.iter())
            .map(|verdict| (verdict.rival.as_str(), verdict.reached))
            .collect();
        // What does other work, or is wrong, is no peer to beat; "any" are the wrong and the fast.
        let expected = [
            ("slow", true),
            ("another sum", false),
            ("slow", true),
            ("nothing", false),
        ];
        assert_eq!(found, expected);
        let impostors: Vec<_> = measured.impostors().map(|e| e.name.as_str()).collect();
        assert_eq!(impostors, ["another sum"]);
        assert_eq!(measured.json()["entries"][3]["fault"], "it stops early");
    }

    /// Says that it needs a quarter of a second a time, and hands in what it was told.
    struct Far {
        sum: f64,
        fails: bool,
    }

    impl Elsewhere<Sum> for Far {
        fn seconds(&mut self, repeats: u32) -> f64 {
            if self.fails {
                f64::NAN
            } else {
                0.25 * f64::from(repeats)
            }
        }

        fn hand_in(&mut self, sum: &mut Sum) {
            sum.0 = self.sum;
        }
    }

    #[test]
    fn a_peer_elsewhere_counts_by_its_own_clock_and_shows_its_own_work() {
        let rounds = Rounds {
            number: 3,
            least_seconds: 0.6,
        };
        let far = |sum, fails| Far { sum, fails };
        let measured = Race::new("sums", "sums".to_owned(), 1.0, "sum", Sum(0.0))
            .clock(Clock::Process)
            .peer_elsewhere("right", far(55.0, false))
            .peer_elsewhere("wrong", far(54.0, false))
            .peer_elsewhere("broken", far(0.0, true))
            .ours("ours", &[], add(10))
            .run(rounds);
        let [right, wrong, broken, _] = measured.entries.as_slice() else {
            panic!("{:?}", measured.entries)
        };
        assert_eq!((right.throughput, right.same_work), (4.0, true));
        assert!(!wrong.same_work && !broken.same_work && broken.throughput.is_nan());
    }

    #[test]
    fn clocks_tell_waiting_from_working() {
        let pause = std::time::Duration::from_millis(40);
        let waited =
            [Clock::Thread, Clock::Wall].map(|clock| clock.time(|| std::thread::sleep(pause)));
        assert!(waited[0] < 0.02 && waited[1] >= 0.04, "{waited:?}");
        // Another thread's work is the process's, not this one's.
        let work = || {
            let start = ThreadTime::now();
            while start.elapsed() < pause {
                black_box(0);
            }
        };
        let elsewhere = || {
            std::thread::scope(|scope| {
                scope.spawn(work);
            });
        };
        let worked = [Clock::Thread, Clock::Process].map(|clock| clock.time(elsewhere));
        assert!(worked[0] < 0.02 && worked[1] >= 0.04, "{worked:?}");
    }
}
