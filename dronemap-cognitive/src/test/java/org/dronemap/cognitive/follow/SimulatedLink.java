package org.dronemap.cognitive.follow;

import java.util.Comparator;
import java.util.PriorityQueue;
import java.util.SplittableRandom;
import java.util.function.Consumer;

/** A link that takes its time, and loses messages; what is quicker overtakes. */
public final class SimulatedLink<T> {
    private final Quality quality;
    private final SplittableRandom random;
    private final PriorityQueue<Message<T>> messages = new PriorityQueue<>(Comparator.comparing(Message::due));

    /** Seconds one way, evenly so much more or less; {@code loss}: the share of messages that never arrive. */
    public record Quality(double seconds, double spread, double loss) {}

    private record Message<T>(double due, T what) {}

    SimulatedLink(Quality quality, long seed) {
        this.quality = quality;
        random = new SplittableRandom(seed);
    }

    void send(double now, T what) {
        double due = now + quality.seconds() + (random.nextDouble() * 2 - 1) * quality.spread();
        if (random.nextDouble() >= quality.loss()) {
            messages.add(new Message<>(due, what));
        }
    }

    void deliver(double now, Consumer<T> to) {
        while (!messages.isEmpty() && messages.peek().due() <= now + 1e-9) {
            to.accept(messages.poll().what());
        }
    }
}
