package org.dronemap.core.virtual;

import org.dronemap.core.command.Refusal;

/**
 * Reason why a drone cannot serve a virtual drone or a follow: a code for programs and a sentence for people.
 *
 * @param code a word for programs: of {@link UnfitCode}, or of what a command would be refused for
 * @param sentence for people
 */
public record UnfitReason(String code, String sentence) {
    public static UnfitReason of(UnfitCode code, String sentence) {
        return new UnfitReason(code.word(), sentence);
    }

    public static UnfitReason of(Refusal why) {
        return new UnfitReason(why.code().word(), why.sentence());
    }
}
