package org.dronemap.cognitive.allocate;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;
import org.dronemap.cognitive.cost.AllocationObjective;
import org.dronemap.cognitive.cost.AllocationProblem;
import org.jspecify.annotations.Nullable;

/**
 * Baseline allocation by a market in which drones claim near waypoints, settle rival claims, and trade as they fly.
 * After Koubaa et al., Move and Improve: a Market-Based Mechanism for the Multiple Depot Multiple Travelling Salesmen
 * Problem (2017); here every drone is in reach of every other.
 */
public final class MoveAndImproveBaseline implements Baseline {
    /** What a drone offers at each stop: the waypoints that are dearest to it. */
    private static final int OFFERS = 8;
    /** A sale must gain more than rounding. */
    private static final double LEAST_GAIN = 1e-9;

    @Override
    public Allocation allocate(AllocationProblem instance) {
        return new Market(instance).close();
    }

    private static final class Market {
        private final AllocationProblem instance;
        private final LegCosts costs;
        private final AllocationObjective aim;
        private final List<BaselineTour> rounds;

        Market(AllocationProblem instance) {
            this.instance = instance;
            aim = instance.aim();
            costs = new LegCosts(instance);
            rounds = BaselineTour.all(instance, costs);
        }

        Allocation close() {
            claim();
            settle();
            fly();
            return Allocation.of(instance, costs, rounds);
        }

        /** Each drone builds a tour of an equal share of waypoints nearest to its start, whoever else wants them. */
        private void claim() {
            int waypoints = instance.visits().size();
            int share = (waypoints + rounds.size() - 1) / rounds.size();
            for (int r = 0; r < rounds.size(); r++) {
                BaselineTour round = rounds.get(r);
                int drone = r;
                IntStream.range(0, waypoints)
                        .filter(waypoint -> costs.allows(waypoint, drone))
                        .boxed()
                        .sorted(Comparator.comparingDouble(round::secondsOnTo))
                        .limit(share)
                        .toList()
                        .forEach(waypoint -> place(round, waypoint));
            }
        }

        private static void place(BaselineTour round, int waypoint) {
            BaselineTour.InsertionPosition gap = round.cheapest(waypoint);
            if (gap != null) {
                round.insert(waypoint, gap.position());
            }
        }

        /** A waypoint that several claim goes to the one whose tour is best with it; one that nobody has is auctioned. */
        private void settle() {
            int waypoints = instance.visits().size();
            for (int waypoint = 0; waypoint < waypoints; waypoint++) {
                int disputed = waypoint;
                claimants(waypoint).stream()
                        .sorted(Comparator.comparingDouble(round -> price(round, disputed)))
                        .skip(1)
                        .forEach(round -> round.remove(round.position(disputed)));
            }
            rounds.forEach(BaselineTour::shorten);
            for (int waypoint = 0; waypoint < waypoints; waypoint++) {
                if (claimants(waypoint).isEmpty()) {
                    auction(waypoint);
                }
            }
        }

        private List<BaselineTour> claimants(int waypoint) {
            return rounds.stream()
                    .filter(round -> round.position(waypoint) >= 0)
                    .toList();
        }

        private double price(BaselineTour claimant, int waypoint) {
            double saving = claimant.saving(claimant.position(waypoint));
            return aim.longestWeight() > 0 ? claimant.seconds() : saving;
        }

        private void auction(int waypoint) {
            Bid best = best(waypoint, null);
            if (best != null) {
                best.buyer().insert(waypoint, best.gap().position());
            }
        }

        private record Bid(BaselineTour buyer, BaselineTour.InsertionPosition gap) {}

        /** The lowest bid; windows and batteries are kept to. */
        private @Nullable Bid best(int waypoint, @Nullable BaselineTour seller) {
            Bid best = null;
            double least = Double.POSITIVE_INFINITY;
            for (BaselineTour round : rounds) {
                BaselineTour.InsertionPosition gap = round.equals(seller) ? null : round.cheapest(waypoint);
                if (gap == null) {
                    continue;
                }
                double price = aim.longestWeight() > 0 ? gap.seconds() : gap.seconds() - round.seconds();
                if (price < least) {
                    least = price;
                    best = new Bid(round, gap);
                }
            }
            return best;
        }

        /** Drones fly from waypoint to waypoint, the one with the shortest way behind it first, and trade at each stop. */
        private void fly() {
            List<BaselineTour> flying = new ArrayList<>(rounds);
            while (!flying.isEmpty()) {
                BaselineTour next = flying.stream()
                        .min(Comparator.comparingInt(BaselineTour::flown))
                        .orElseThrow();
                if (next.hasFlownAll()) {
                    flying.remove(next);
                } else {
                    sell(next);
                    next.move();
                }
            }
        }

        private void sell(BaselineTour seller) {
            List<Integer> dearest = IntStream.range(seller.flown(), seller.size())
                    .boxed()
                    .sorted(Comparator.comparingDouble(position -> -seller.saving(position)))
                    .limit(OFFERS)
                    .map(seller::waypoint)
                    .toList();
            dearest.forEach(waypoint -> offer(seller, waypoint));
        }

        private void offer(BaselineTour seller, int waypoint) {
            int position = seller.position(waypoint);
            boolean keeps = (aim.everyDrone() && seller.size() == 1) || !seller.spares(position);
            Bid bid = keeps ? null : best(waypoint, seller);
            if (bid == null) {
                return;
            }
            double kept = seller.seconds() - seller.saving(position);
            double gain = worth(seller.seconds(), bid.buyer().seconds())
                    - worth(kept, bid.gap().seconds());
            if (gain > LEAST_GAIN) {
                seller.remove(position);
                bid.buyer().insert(waypoint, bid.gap().position());
            }
        }

        private double worth(double one, double other) {
            return aim.longestWeight() > 0 ? Math.max(one, other) : one + other;
        }
    }
}
