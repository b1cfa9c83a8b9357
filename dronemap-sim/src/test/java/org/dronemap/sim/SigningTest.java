package org.dronemap.sim;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Instant;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.mavlink.message.ParamRequestRead;
import org.dronemap.mavlink.message.ParamValue;
import org.dronemap.mavlink.message.SetupSigning;
import org.dronemap.mavlink.signing.OutgoingSigner;
import org.dronemap.mavlink.signing.SignatureCheck;
import org.dronemap.mavlink.signing.SigningClock;
import org.dronemap.mavlink.signing.SigningKey;
import org.junit.jupiter.api.Test;

class SigningTest {
    private static final SigningKey KEY = key(1);
    private static final Instant START = Instant.parse("2026-03-01T12:00:00Z");
    private static final Message QUESTION = new ParamRequestRead(1, 1, "FS_GCS_ENABLE", -1);

    private final SigningClock clock = new SigningClock(() -> START, 0);

    private static SigningKey key(int first) {
        byte[] secret = new byte[SigningKey.BYTES];
        for (int i = 0; i < secret.length; i++) {
            secret[i] = (byte) (first + i);
        }
        return new SigningKey(secret);
    }

    private SetupSigning setup(SigningKey key) {
        int[] secret = new int[SigningKey.BYTES];
        for (int i = 0; i < secret.length; i++) {
            secret[i] = key.secret()[i] & 0xFF;
        }
        return new SetupSigning(1, 1, secret, clock.next());
    }

    private VehicleTestBench signing(String... options) {
        VehicleTestBench bench = VehicleTestBench.ready(options);
        bench.send(setup(KEY));
        bench.heard.clear();
        return bench;
    }

    private static boolean answers(VehicleTestBench bench) {
        return bench.count(ParamValue.ID) > 0;
    }

    @Test
    void signsEverythingOnceItHasAKeyWithATimeThatTheSenderAccepts() {
        VehicleTestBench bench = signing();
        bench.run(3);

        SignatureCheck check = new SignatureCheck(KEY, clock);
        assertThat(bench.heard).hasSizeGreaterThan(3);
        assertThat(bench.heard)
                .allSatisfy(heard ->
                        assertThat(check.judge(heard.frame()).isValid()).isTrue());
    }

    @Test
    void listensToItsKeyOnly() {
        VehicleTestBench bench = signing();
        bench.send(QUESTION);
        bench.send(QUESTION, new OutgoingSigner(key(7), clock, 0));
        assertThat(answers(bench)).isFalse();
        assertThat(bench.vehicle.signing().refused()).isEqualTo(2);

        bench.send(QUESTION, new OutgoingSigner(KEY, clock, 0));
        assertThat(answers(bench)).isTrue();
    }

    @Test
    void listensToEverybodyOnTheFirstChannel() {
        VehicleTestBench bench = signing("--usb");
        bench.send(QUESTION);
        assertThat(answers(bench)).isTrue();
    }

    @Test
    void takesANewKeyFromWhoHasTheOldOneAndForgetsItForZeros() {
        VehicleTestBench bench = signing();
        bench.send(setup(key(7)));
        bench.send(QUESTION, new OutgoingSigner(KEY, clock, 0));
        assertThat(answers(bench)).isTrue();
        bench.send(setup(key(7)), new OutgoingSigner(KEY, clock, 0));
        bench.heard.clear();
        bench.send(QUESTION, new OutgoingSigner(KEY, clock, 0));
        assertThat(answers(bench)).isFalse();
        bench.send(new SetupSigning(1, 1, new int[32], 0), new OutgoingSigner(key(7), clock, 0));

        bench.send(QUESTION);
        assertThat(answers(bench)).isTrue();
        assertThat(bench.heard).extracting(VehicleTestBench.Heard::frame).noneMatch(Frame::signed);
    }

    @Test
    void keepsItsKeyOverAReboot() {
        VehicleTestBench bench = signing();
        bench.vehicle.reboot();
        bench.run(4);
        assertThat(bench.vehicle.signing().isOn()).isTrue();
        assertThat(bench.heard)
                .last()
                .satisfies(heard -> assertThat(heard.frame().signed()).isTrue());
    }

    @Test
    void aCopterTakesNoKeyWhileItIsArmed() {
        VehicleTestBench bench = VehicleTestBench.flying(10);
        bench.send(setup(KEY));
        assertThat(bench.texts()).contains("ERROR: Won't setup signing when armed");
        assertThat(bench.vehicle.signing().isOn()).isFalse();
    }

    @Test
    void theOtherPersonalitySignsAsWell() {
        VehicleTestBench bench = signing("--personality", "px4");
        bench.run(3);
        assertThat(bench.heard).isNotEmpty().allMatch(heard -> heard.frame().signed());
        assertThat(bench.heard).anyMatch(heard -> heard.frame().messageId() == Heartbeat.ID);
    }
}
