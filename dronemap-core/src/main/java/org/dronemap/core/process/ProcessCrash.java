package org.dronemap.core.process;

import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;

/**
 * Record of a crash of an earlier process of this server: when, why and while processing whose bytes.
 *
 * @param at its last sign of life
 * @param part what could not go on, such as the name of a thread
 * @param why as a sentence
 * @param peers whose bytes were being worked on
 */
public record ProcessCrash(Instant at, String part, String why, List<PeerPattern> peers) {
    private static final String BETWEEN = "\t";
    private static final int PEERS = 3;

    public ProcessCrash {
        peers = List.copyOf(peers);
    }

    /** One line. */
    public String text() {
        List<String> fields = new ArrayList<>(List.of(at.toString(), plain(part), plain(why)));
        peers.forEach(peer -> fields.add(plain(peer.text())));
        return String.join(BETWEEN, fields);
    }

    /**
     * What {@link #text} wrote.
     *
     * @throws RuntimeException when it is something else
     */
    public static ProcessCrash of(String text) {
        List<String> fields = List.of(text.split(BETWEEN, -1));
        return new ProcessCrash(
                Instant.parse(fields.get(0)),
                fields.get(1),
                fields.get(2),
                names(fields.subList(PEERS, fields.size())));
    }

    /** Those of the texts that are names. */
    public static List<PeerPattern> names(List<String> texts) {
        return texts.stream()
                .flatMap(text -> Stream.ofNullable(PeerPattern.of(text)))
                .distinct()
                .toList();
    }

    private static String plain(String text) {
        return text.replaceAll("\\p{Cntrl}", " ");
    }
}
