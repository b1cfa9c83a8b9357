package org.dronemap.proxy.mavlink.translate;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.PayloadWriter;
import org.dronemap.mavlink.message.Statustext;
import org.junit.jupiter.api.Test;

/** Long sentences in pieces of fifty bytes, by several components of one vehicle. */
class StatustextJoinerTest {
    private static final int PIECE = 50;
    private static final int AUTOPILOT = 1;
    private static final int COMPANION = 191;
    private static final int GIMBAL = 154;
    private static final long SECOND = 1_000_000_000L;

    private final List<String> told = new ArrayList<>();
    private final StatustextJoiner joiner = new StatustextJoiner((severity, text) -> told.add(severity + " " + text));
    private long now = 50 * SECOND;

    private static String padded(String text) {
        return text + "-".repeat(PIECE - text.length());
    }

    private void says(int component, int id, int piece, String text) {
        says(component, 4, id, piece, text);
    }

    private void says(int component, int severity, int id, int piece, String text) {
        joiner.received(VehicleFrames.of(component, new Statustext(severity, text, id, piece)), now);
    }

    private void saysBytes(int id, int piece, byte[] text) {
        joiner.received(
                VehicleFrames.of(AUTOPILOT, new Message() {
                    @Override
                    public int messageId() {
                        return Statustext.ID;
                    }

                    @Override
                    public void write(PayloadWriter out) {
                        out.u8(6);
                        for (int i = 0; i < PIECE; i++) {
                            out.u8(i < text.length ? text[i] : 0);
                        }
                        out.u16(id);
                        out.u8(piece);
                    }
                }),
                now);
    }

    private void after(double seconds) {
        now += (long) (seconds * SECOND);
        joiner.advance(now);
    }

    @Test
    void sentencesOfTwoComponentsWithOneNumberAreBothTold() {
        says(AUTOPILOT, 9, 0, padded("by the autopilot"));
        says(COMPANION, 9, 0, padded("by the companion"));
        says(AUTOPILOT, 9, 1, "A");
        says(COMPANION, 9, 1, "C");
        assertThat(told)
                .containsExactly(
                        "WARNING " + padded("by the autopilot") + "A", "WARNING " + padded("by the companion") + "C");
    }

    @Test
    void severityIsThatOfEachSentence() {
        says(AUTOPILOT, 2, 9, 0, padded("critical"));
        says(GIMBAL, 6, 9, 0, padded("info"));
        says(GIMBAL, 6, 9, 1, "!");
        says(AUTOPILOT, 2, 9, 1, "!");
        assertThat(told).containsExactly("INFO " + padded("info") + "!", "CRITICAL " + padded("critical") + "!");
    }

    @Test
    void sentencesOfOneComponentMayOverlap() {
        says(AUTOPILOT, 1, 0, padded("first"));
        says(AUTOPILOT, 2, 0, padded("second"));
        says(AUTOPILOT, 1, 1, "1");
        says(AUTOPILOT, 2, 1, "2");
        assertThat(told).containsExactly("WARNING " + padded("first") + "1", "WARNING " + padded("second") + "2");
    }

    @Test
    void numbersBeginAnewWithEachBoot() {
        says(AUTOPILOT, 1, 0, padded("first boot"));
        says(AUTOPILOT, 1, 1, "1");
        after(0.3);
        says(AUTOPILOT, 1, 0, padded("second boot"));
        says(AUTOPILOT, 1, 1, "2");
        after(2);
        says(AUTOPILOT, 1, 0, padded("second boot"));
        says(AUTOPILOT, 1, 1, "2");
        assertThat(told)
                .containsExactly(
                        "WARNING " + padded("first boot") + "1",
                        "WARNING " + padded("second boot") + "2",
                        "WARNING " + padded("second boot") + "2");
    }

    @Test
    void aBootInTheMiddleOfASentenceLosesNeither() {
        says(AUTOPILOT, 1, 0, padded("begun before the boot"));
        says(AUTOPILOT, 1, 0, padded("begun after it"));
        says(AUTOPILOT, 1, 1, "and ended");
        assertThat(told)
                .containsExactly(
                        "WARNING " + padded("begun before the boot") + " …",
                        "WARNING " + padded("begun after it") + "and ended");
    }

    @Test
    void whatComesTwiceIsToldOnce() {
        for (int piece : List.of(0, 0, 1, 1, 0)) {
            says(AUTOPILOT, 3, piece, piece == 0 ? padded("a") : "b");
        }
        after(3);
        assertThat(told).containsExactly("WARNING " + padded("a") + "b");
    }

    @Test
    void piecesThatOvertakeEachOtherAreInOrder() {
        says(AUTOPILOT, 3, 1, padded("b"));
        says(AUTOPILOT, 3, 2, "c");
        says(AUTOPILOT, 3, 0, padded("a"));
        after(3);
        assertThat(told).containsExactly("WARNING " + padded("a") + padded("b") + "c");
    }

    @Test
    void lostPiecesAreToldAsGaps() {
        says(AUTOPILOT, 3, 1, padded("b"));
        says(AUTOPILOT, 3, 3, "d");
        after(0.5);
        assertThat(told).isEmpty();
        after(1);
        says(AUTOPILOT, 3, 2, padded("late"));
        after(2);
        assertThat(told).containsExactly("WARNING … " + padded("b") + " … d", "WARNING … " + padded("late") + " …");
    }

    @Test
    void aLetterMayLieAcrossTwoPieces() {
        byte[] whole = ("x".repeat(PIECE - 1) + "é!").getBytes(StandardCharsets.UTF_8);
        saysBytes(4, 0, java.util.Arrays.copyOfRange(whole, 0, PIECE));
        saysBytes(4, 1, java.util.Arrays.copyOfRange(whole, PIECE, whole.length));
        assertThat(told).containsExactly("INFO " + "x".repeat(PIECE - 1) + "é!");
    }

    @Test
    void nothingIsLostOfEndlessAndOfCountlessSentences() {
        for (int piece = 0; piece < 20; piece++) {
            says(AUTOPILOT, 5, piece, padded("piece " + piece));
        }
        for (int id = 10; id < 200; id++) {
            says(AUTOPILOT, id, 0, padded("sentence " + id));
        }
        after(3);
        String all = String.join("\n", told);
        for (int piece = 0; piece < 20; piece++) {
            assertThat(all).containsOnlyOnce(padded("piece " + piece));
        }
        for (int id = 10; id < 200; id++) {
            assertThat(all).containsOnlyOnce(padded("sentence " + id));
        }
    }
}
