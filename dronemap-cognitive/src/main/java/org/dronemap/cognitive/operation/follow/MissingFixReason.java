package org.dronemap.cognitive.operation.follow;

import org.dronemap.core.operation.ReporterState;
import org.dronemap.core.stored.Stored;
import org.jspecify.annotations.Nullable;

/** The reason why a followed phone's position fixes do not arrive, such as no network or a closed page. */
@Stored(names = "BLIND VAGUE ASLEEP CUT GONE SILENT")
public enum MissingFixReason {
    /** It is there, and finds no position. */
    BLIND("The phone does not know where it is: it lets its page find no position."),
    /** It says where it is, to more than fifty metres. */
    VAGUE("The phone knows its place to no better than 50 m."),
    ASLEEP("The phone's page stands still: the screen is off, or something else is in front of it."),
    CUT("The phone cannot be reached: it has no network."),
    GONE("The phone's page was closed, or has crashed."),
    /** How it is reached is not known. */
    SILENT("The phone says nothing any more.");

    private final String words;

    MissingFixReason(String words) {
        this.words = words;
    }

    String words() {
        return words;
    }

    static MissingFixReason of(@Nullable ReporterState reach) {
        if (reach == null) {
            return SILENT;
        }
        return switch (reach) {
            case SPEAKS -> BLIND;
            case VAGUE -> VAGUE;
            case ASLEEP -> ASLEEP;
            case CUT -> CUT;
            case GONE -> GONE;
        };
    }
}
