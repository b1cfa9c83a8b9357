package org.dronemap.proxy.outlet.uplink;

import java.util.Set;
import org.dronemap.mavlink.message.FileTransferProtocol;

/**
 * Refuses MAVLink file transfer at the outlet, so that ground stations fetch parameters and logs by messages. The bytes
 * are those of the <a href="https://mavlink.io/en/services/ftp.html">file transfer protocol</a>.
 */
final class FtpRefusalHandler {
    private static final int SESSION = 2;
    private static final int OPCODE = 3;
    private static final int SIZE = 4;
    private static final int ANSWERED_OPCODE = 5;
    private static final int DATA = 12;

    private static final int ACK = 128;
    private static final int NAK = 129;

    /** They end what never began: none, terminate session, reset sessions. */
    private static final Set<Integer> ENDING = Set.of(0, 1, 2);
    /** List directory, open file read-only, its checksum, burst read. */
    private static final Set<Integer> READING = Set.of(3, 4, 14, 15);
    /** Create, write and remove file, create and remove directory, open for writing, truncate, rename. */
    private static final Set<Integer> WRITING = Set.of(6, 7, 8, 9, 10, 11, 12, 13);

    private static final int UNKNOWN_COMMAND = 7;
    private static final int FILE_PROTECTED = 9;
    private static final int FILE_NOT_FOUND = 10;

    private FtpRefusalHandler() {}

    static void handle(ClientRequest asked) {
        FileTransferProtocol question = FileTransferProtocol.decode(asked.frame());
        int opcode = question.payload()[OPCODE];
        if (opcode >= ACK) {
            // An answer is no question, or two servers would talk for ever.
            return;
        }
        int[] answer = new int[question.payload().length];
        int number = (question.payload()[0] | question.payload()[1] << 8) + 1;
        answer[0] = number & 0xFF;
        answer[1] = number >> 8 & 0xFF;
        answer[SESSION] = question.payload()[SESSION];
        answer[ANSWERED_OPCODE] = opcode;
        if (ENDING.contains(opcode)) {
            answer[OPCODE] = ACK;
        } else {
            answer[OPCODE] = NAK;
            answer[SIZE] = 1;
            answer[DATA] = reason(opcode);
        }
        asked.answer(new FileTransferProtocol(0, asked.fromSystem(), asked.fromComponent(), answer));
    }

    private static int reason(int opcode) {
        if (READING.contains(opcode)) {
            return FILE_NOT_FOUND;
        }
        return WRITING.contains(opcode) ? FILE_PROTECTED : UNKNOWN_COMMAND;
    }
}
