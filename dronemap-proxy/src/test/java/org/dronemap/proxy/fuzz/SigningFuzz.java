package org.dronemap.proxy.fuzz;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.InstantSource;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.dronemap.core.access.LinkKey;
import org.dronemap.core.access.LinkSecurity;
import org.dronemap.core.access.LinkSigningPolicy;
import org.dronemap.core.cloud.lane.StoreWriter;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.time.RealTime;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.message.SetupSigning;
import org.dronemap.mavlink.signing.OutgoingSigner;
import org.dronemap.mavlink.signing.SigningClock;
import org.dronemap.mavlink.signing.SigningKey;
import org.dronemap.proxy.TestKeyrings;
import org.dronemap.proxy.signing.FrameAdmission;
import org.dronemap.proxy.signing.KeyringRegistry;
import org.dronemap.proxy.signing.LinkGuard;

/** Right, foreign, doubled, bent and missing signatures under any payload: only a right one that is new is believed. */
final class SigningFuzz {
    private static final int WARM_UP = 2_000;
    private static final int SENDERS = 8;
    private static final int SIGNATURE_BYTES = 13;

    private final Random random;
    private final HostileFrames hostile;
    private final String name;
    private final SigningClock clock = new SigningClock(InstantSource.system(), 0);
    private final SigningKey own;
    private final SigningKey foreign;
    private final LinkGuard guard;
    private long rounds;

    private SigningFuzz(FuzzBudget budget, StoreWriter journal) {
        random = budget.random();
        hostile = new HostileFrames(random, 1);
        name = budget.name();
        byte[] secret = secret();
        own = new SigningKey(secret);
        foreign = new SigningKey(secret());
        DroneId drone = new DroneId("d7k2m9q4xa");
        TestKeyrings kept = new TestKeyrings();
        kept.save(new LinkSecurity(drone, LinkSigningPolicy.REQUIRED, new LinkKey(secret), null, true, 0));
        KeyringRegistry keyrings = new KeyringRegistry(
                new KeyringRegistry.Dependencies(kept, journal, known -> 1, (known, sentence) -> {}), new RealTime());
        guard = keyrings.guard(0, () -> true);
        guard.bound(drone, 1);
    }

    private byte[] secret() {
        byte[] secret = new byte[LinkKey.BYTES];
        random.nextBytes(secret);
        return secret;
    }

    static long run(FuzzBudget budget) {
        try (StoreWriter journal = new StoreWriter(new RealTime())) {
            SigningFuzz fuzz = new SigningFuzz(budget, journal);
            HeapGrowthCheck heap = new HeapGrowthCheck();
            while (budget.isLeft()) {
                fuzz.round();
            }
            heap.check(budget.name());
            return fuzz.rounds;
        }
    }

    private void round() {
        rounds++;
        switch (random.nextInt(4)) {
            case 0 -> expect(hostile.next(), FrameAdmission.REFUSED, FrameAdmission.ASIDE);
            case 1 -> expect(hostile.signed(by(foreign)), FrameAdmission.REFUSED);
            case 2 -> {
                byte[] bent = hostile.signed(by(own));
                bent[bent.length - 1 - random.nextInt(SIGNATURE_BYTES)] ^= (byte) (1 << random.nextInt(8));
                expect(bent, FrameAdmission.REFUSED);
            }
            default -> {
                byte[] right = hostile.signed(by(own));
                expect(right, FrameAdmission.PROVEN);
                expect(right, FrameAdmission.REFUSED);
            }
        }
    }

    private OutgoingSigner by(SigningKey key) {
        return new OutgoingSigner(key, clock, random.nextInt(SENDERS));
    }

    private void expect(byte[] bytes, FrameAdmission... allowed) {
        for (Frame frame : HostileFrames.parsed(bytes)) {
            List<FrameAdmission> judged = new ArrayList<>();
            Runnable work = () -> judged.add(guard.judge(frame, System.nanoTime()));
            if (rounds < WARM_UP) {
                work.run();
            } else {
                SlowInputCheck.check(name, bytes, work);
            }
            if (frame.messageId() == SetupSigning.ID) {
                assertThat(judged).as(name).containsOnly(FrameAdmission.REFUSED);
            } else {
                assertThat(judged.get(0)).as(name).isIn((Object[]) allowed);
            }
        }
    }
}
