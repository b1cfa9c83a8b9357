package org.dronemap.core.virtual;

import org.dronemap.core.command.Refusal;

/**
 * Why a drone cannot serve a virtual drone or a follow: a code for programs and a sentence for people.
 *
 * @param code a word for programs: of {@link UnfitCode}, or of what a command would be refused for
 * @param sentence for people
 */
public record Against(String code, String sentence) {
    public static Against of(UnfitCode code, String sentence) {
        return new Against(code.word(), sentence);
    }

    public static Against of(Refusal why) {
        return new Against(why.code().word(), why.sentence());
    }
}
