package org.jsmesh.load;

import java.util.Arrays;
import java.util.List;
import java.util.function.Predicate;

/** Some of the rounds, as figures. */
final class RoundFigures {
    private final List<Tally.Round> rounds;

    private RoundFigures(List<Tally.Round> rounds) {
        this.rounds = rounds;
    }

    static RoundFigures of(List<Tally.Round> all, Predicate<Tally.Round> which) {
        return new RoundFigures(all.stream().filter(which).toList());
    }

    RoundFigures where(Predicate<Tally.Round> which) {
        return of(rounds, which);
    }

    /** Those that no fault of the test hit. */
    RoundFigures spared() {
        return where(r -> !r.hit());
    }

    /** Those that did not end early because everything was there. */
    RoundFigures beforeTheLast() {
        return where(r -> !r.complete());
    }

    int count() {
        return rounds.size();
    }

    /** Wait ÷ T of the given share of the rounds; NaN without any. */
    double wait(double share) {
        return quantile(rounds.stream().mapToDouble(Tally.Round::waitShare).toArray(), share);
    }

    double detail(double share) {
        return quantile(rounds.stream().mapToDouble(Tally.Round::detailShare).toArray(), share);
    }

    double meanDetail() {
        return rounds.stream().mapToDouble(Tally.Round::detailShare).average().orElse(Double.NaN);
    }

    double meanRequests() {
        return rounds.stream().mapToInt(Tally.Round::requests).average().orElse(Double.NaN);
    }

    private static double quantile(double[] values, double share) {
        if (values.length == 0) return Double.NaN;
        Arrays.sort(values);
        return values[Math.min(values.length - 1, (int) (share * values.length))];
    }
}
