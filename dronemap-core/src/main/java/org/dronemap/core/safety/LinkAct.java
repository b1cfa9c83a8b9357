package org.dronemap.core.safety;

import org.dronemap.core.command.ChangeSpeed;
import org.dronemap.core.command.Command;
import org.jspecify.annotations.Nullable;

/**
 * Act on a flying drone whose link is expected to be lost soon, or no longer is.
 *
 * @param reason sentences for users
 */
public record LinkAct(Kind kind, @Nullable Command command, String reason) {
    /** Kind of such an act. */
    public enum Kind {
        /** Users are told what to do: it is in somebody's hand. */
        WARN,
        /** It climbs: a higher antenna sees farther. */
        CLIMB,
        /** It goes on slower, and is heard for longer. */
        SLOW_DOWN,
        /** It comes home. */
        RETURN,
        /** The link is good again: it goes on as before. */
        GO_ON
    }

    static LinkAct warn(String reason) {
        return new LinkAct(Kind.WARN, null, reason);
    }

    static LinkAct climb(Command.GoTo up, String reason) {
        return new LinkAct(Kind.CLIMB, up, reason);
    }

    static LinkAct slowDown(ChangeSpeed slower, String reason) {
        return new LinkAct(Kind.SLOW_DOWN, slower, reason);
    }

    static LinkAct comeHome(String reason) {
        return new LinkAct(Kind.RETURN, null, reason);
    }

    static LinkAct goOn(@Nullable Command with, String reason) {
        return new LinkAct(Kind.GO_ON, with, reason);
    }
}
