package org.dronemap.proxy.mavlink.procedure;

import java.util.function.Function;
import java.util.function.Predicate;
import org.dronemap.core.command.Outcome;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.message.CommandLong;
import org.dronemap.mavlink.message.HomePosition;
import org.jspecify.annotations.Nullable;

/**
 * Requests a vehicle's home position until it reports the expected one, or keeps reporting another. What was under way
 * before the question may be said still.
 */
public final class HomeRead implements Exchange {
    private static final int REQUEST_MESSAGE = 512;
    private static final int GET_HOME_POSITION = 410;
    private static final int OTHERS_BEFORE_FAILURE = 4;
    private static final long LEAST_PAUSE_NANOS = 500_000_000L;

    private final MavlinkTarget target;
    private final Predicate<HomePosition> wanted;
    private final Function<HomePosition, String> words;
    private final TransferTimeout patience = new TransferTimeout();
    private int tries;
    private int others;
    private long lastSentNanos;
    private @Nullable Outcome outcome;

    /** {@code words}: a sentence about a home that is not the wanted one. */
    public HomeRead(MavlinkTarget target, Predicate<HomePosition> wanted, Function<HomePosition, String> words) {
        this.target = target;
        this.wanted = wanted;
        this.words = words;
    }

    @Override
    public void start(long nowNanos) {
        patience.begin(nowNanos);
        ask(nowNanos);
    }

    @Override
    public void received(Frame frame, long nowNanos) {
        patience.received(nowNanos);
        if (outcome == null && frame.messageId() == HomePosition.ID) {
            HomePosition home = HomePosition.decode(frame);
            if (wanted.test(home)) {
                outcome = new Outcome.Succeeded();
            } else if (++others >= OTHERS_BEFORE_FAILURE) {
                outcome = new Outcome.Failed(words.apply(home));
            }
        }
    }

    @Override
    public void advance(long nowNanos) {
        if (outcome == null && nowNanos - lastSentNanos >= pauseNanos()) {
            outcome = patience.end(nowNanos);
            if (outcome == null) {
                ask(nowNanos);
            }
        }
    }

    /** In turns the newer question and the older one, since no vehicle knows both for sure. */
    private void ask(long nowNanos) {
        boolean older = tries % 2 == 1;
        target.send(new CommandLong(
                target.systemId(),
                target.componentId(),
                older ? GET_HOME_POSITION : REQUEST_MESSAGE,
                0,
                older ? 0f : HomePosition.ID,
                0f,
                0f,
                0f,
                0f,
                0f,
                0f));
        patience.asked(nowNanos);
        tries++;
        lastSentNanos = nowNanos;
    }

    /** As the link is now: a long transfer may begin on a good one and go on over a bad one. */
    private long pauseNanos() {
        return Math.max(
                LEAST_PAUSE_NANOS, RetrySchedule.of(target.roundTrip(), 0).pauseNanos(tries));
    }

    @Override
    public @Nullable Outcome outcome() {
        return outcome;
    }
}
