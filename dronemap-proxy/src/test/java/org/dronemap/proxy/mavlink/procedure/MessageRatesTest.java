package org.dronemap.proxy.mavlink.procedure;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.message.Attitude;
import org.dronemap.mavlink.message.CommandAck;
import org.dronemap.mavlink.message.CommandLong;
import org.dronemap.mavlink.message.GlobalPositionInt;
import org.dronemap.mavlink.message.RequestDataStream;
import org.junit.jupiter.api.Test;

class MessageRatesTest {
    private static final long SECOND = 1_000_000_000L;
    private static final int SET_MESSAGE_INTERVAL = 511;
    private static final int UNSUPPORTED = 3;
    private static final Attitude ATTITUDE = new Attitude(1, 0, 0, 0, 0, 0, 0);
    private static final GlobalPositionInt POSITION =
            new GlobalPositionInt(1, 474_000_000, 85_000_000, 500_000, 0, 0, 0, 0, 0);

    private final TestWire wire = new TestWire();
    private final MessageRateRequester rates = new MessageRateRequester(wire.target());
    private long now = 1_000 * SECOND;

    /** Lets time pass in which these come four times a second. */
    private void run(double seconds, Message... flowing) {
        long end = now + (long) (seconds * SECOND);
        for (int tick = 0; now < end; tick++, now += 20_000_000L) {
            if (tick % 12 == 0) {
                for (Message message : flowing) {
                    rates.received(wire.frame(message), now);
                }
            }
            rates.advance(now);
        }
    }

    private List<CommandLong> asksFor(int messageId) {
        return wire.sent(CommandLong.class).stream()
                .filter(ask -> ask.command() == SET_MESSAGE_INTERVAL && ask.param1() == messageId)
                .toList();
    }

    @Test
    void asksOnceForWhatFlowsThen() {
        run(20, ATTITUDE, POSITION);

        assertThat(asksFor(Attitude.ID))
                .singleElement()
                .satisfies(ask -> assertThat(ask.param2()).isEqualTo(250_000f));
        assertThat(wire.sent(RequestDataStream.class)).isEmpty();
    }

    @Test
    void asksAgainForWhatStopped() {
        run(10, ATTITUDE, POSITION);
        run(10, POSITION);

        assertThat(asksFor(Attitude.ID)).hasSizeGreaterThan(1);
        assertThat(asksFor(GlobalPositionInt.ID)).hasSize(1);
    }

    @Test
    void doesNotPesterAVehicleForWhatItNeverTells() {
        run(120, POSITION);

        assertThat(asksFor(Attitude.ID)).hasSizeBetween(4, 9);
    }

    @Test
    void asksInTheOldWayWhereTheNewOneIsNotKnown() {
        run(1);
        rates.received(wire.frame(new CommandAck(SET_MESSAGE_INTERVAL, UNSUPPORTED, 0, 0, 255, 190)), now);
        run(1);

        assertThat(wire.sent(RequestDataStream.class)).hasSize(5).allMatch(stream -> stream.startStop() == 1);
    }
}
