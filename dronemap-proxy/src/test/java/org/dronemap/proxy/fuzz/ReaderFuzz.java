package org.dronemap.proxy.fuzz;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.FrameReader;
import org.dronemap.mavlink.FrameWriter;
import org.dronemap.mavlink.message.Heartbeat;

/** Broken, cut, spliced and lying frames in pieces of any size, and one good frame behind them that must be found. */
final class ReaderFuzz {
    private static final byte[] GOOD = new FrameWriter(77, 7, 2).frame(new Heartbeat(2, 3, 81, 4, 4, 3));
    private static final int WARM_UP = 2_000;

    private final Random random;
    private final HostileFrames hostile;
    private final FrameReader reader = new FrameReader();

    private ReaderFuzz(Random random) {
        this.random = random;
        hostile = new HostileFrames(random, 3);
    }

    static long run(FuzzBudget budget) {
        ReaderFuzz fuzz = new ReaderFuzz(budget.random());
        HeapGrowthCheck heap = new HeapGrowthCheck();
        long rounds = 0;
        while (budget.isLeft()) {
            byte[] input = fuzz.input();
            if (rounds++ < WARM_UP) {
                fuzz.feed(fuzz.reader, input);
            } else {
                SlowInputCheck.check(budget.name(), input, () -> fuzz.feed(fuzz.reader, input));
            }
            fuzz.findsWhatIsGood(input, budget.name());
        }
        heap.check(budget.name());
        return rounds;
    }

    private byte[] input() {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        for (int parts = 1 + random.nextInt(4); parts > 0; parts--) {
            byte[] part = random.nextInt(8) == 0 ? noise() : hostile.next();
            switch (random.nextInt(5)) {
                case 0 -> part[random.nextInt(part.length)] = (byte) random.nextInt(256);
                case 1 -> part = Arrays.copyOf(part, random.nextInt(part.length + 1));
                case 2 -> part[Math.min(1 + random.nextInt(2), part.length - 1)] = (byte) random.nextInt(256);
                default -> {}
            }
            out.writeBytes(part);
        }
        return out.toByteArray();
    }

    private byte[] noise() {
        byte[] noise = new byte[1 + random.nextInt(300)];
        random.nextBytes(noise);
        for (int i = random.nextInt(6); i > 0; i--) {
            noise[random.nextInt(noise.length)] = (byte) (random.nextBoolean() ? 0xFD : 0xFE);
        }
        return noise;
    }

    private void feed(FrameReader into, byte[] input) {
        int at = 0;
        while (at < input.length) {
            int length = Math.min(input.length - at, 1 + random.nextInt(400));
            ByteBuffer piece = ByteBuffer.wrap(input, at, length).slice();
            if (random.nextBoolean()) {
                into.read(piece, frame -> {});
            } else {
                into.readDatagram(piece, frame -> {});
            }
            at += length;
        }
    }

    /** Whatever stands before it and lies about its length: a good frame is found when the input ends. */
    private void findsWhatIsGood(byte[] input, String name) {
        List<Frame> found = new ArrayList<>();
        FrameReader fresh = new FrameReader();
        fresh.read(ByteBuffer.wrap(input), frame -> {});
        fresh.endOfInput(frame -> {});
        fresh.read(ByteBuffer.wrap(GOOD), found::add);
        fresh.endOfInput(found::add);
        assertThat(found).as(name).anySatisfy(frame -> assertThat(frame.bytes()).isEqualTo(GOOD));
    }
}
