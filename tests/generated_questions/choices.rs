use rand_xoshiro::Xoshiro256PlusPlus;
use rand_xoshiro::rand_core::{RngCore, SeedableRng};

/// Choices determined by a seed.
pub struct Choices {
    random: Xoshiro256PlusPlus,
    /// True if the question may have mistakes. Each choice is then a mistake with probability 0.1:
    /// more mistakes would be useless, because the program reports only the first one.
    is_careless: bool,
    /// True if the drives of the question are given by their launch.
    pub is_launched: bool,
    /// True if rows of a file state the launches: the question then states parameters of the flight
    /// only.
    pub is_of_flight: bool,
    /// True if goals and limits are means over many swings.
    pub is_over_swings: bool,
}

impl Choices {
    /// The choices of a question: determined by seed and number.
    pub fn new(seed: u64, number: u64) -> Self {
        let mut random = Xoshiro256PlusPlus::seed_from_u64(seed);
        let random = Xoshiro256PlusPlus::seed_from_u64(random.next_u64() ^ number);
        let mut choices = Self {
            random,
            is_careless: false,
            is_launched: false,
            is_of_flight: false,
            is_over_swings: false,
        };
        choices.is_careless = choices.is(0.3);
        choices
    }

    /// Decides whether the next choice is a mistake.
    pub fn makes_mistake(&mut self) -> bool {
        self.is_careless && self.is(0.1)
    }

    /// One of `good`, or by mistake one of `bad`.
    pub fn good_or_bad<T: Clone>(&mut self, good: &[T], bad: &[T]) -> T {
        let all = if self.makes_mistake() { bad } else { good };
        self.of(all)
    }

    /// A number from 0 to 1, uniformly distributed.
    pub fn uniform(&mut self) -> f64 {
        (self.random.next_u64() >> 11) as f64 / (1_u64 << 53) as f64
    }

    pub fn is(&mut self, probability: f64) -> bool {
        self.uniform() < probability
    }

    pub fn below(&mut self, end: usize) -> usize {
        (self.uniform() * end as f64) as usize
    }

    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.uniform()
    }

    pub fn of<T: Clone>(&mut self, all: &[T]) -> T {
        all[self.below(all.len())].clone()
    }

    /// An index, with a probability proportional to its weight.
    pub fn weighted(&mut self, weights: &[f64]) -> usize {
        let mut left = self.uniform() * weights.iter().sum::<f64>();
        let found = weights.iter().position(|weight| {
            left -= weight;
            left < 0.0
        });
        found.unwrap_or(weights.len() - 1)
    }
}
