package org.dronemap.proxy.roslink.wire;

/** The result of parsing bytes from a robot: a ROSLink packet, or the reason why there is none. */
public sealed interface PacketReadResult {
    record Good(RoslinkPacket packet) implements PacketReadResult {}

    record Bad(Fault fault) implements PacketReadResult {}

    /** The reason why bytes are no message. */
    enum Fault {
        TOO_LONG("is longer than may be"),
        NO_JSON("is not one whole JSON object, or too deep or too large a one"),
        NO_HEADER("has no system id and message id of whole numbers in their ranges"),
        WITHOUT_DATA("is an image or a map without data");

        private final String phrase;

        Fault(String phrase) {
            this.phrase = phrase;
        }

        /** Completes the sentence "what came …". */
        public String phrase() {
            return phrase;
        }
    }
}
