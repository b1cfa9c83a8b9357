package org.dronemap.ws.journal;

import java.util.List;
import org.dronemap.cognitive.operation.follow.FollowInput;
import org.dronemap.cognitive.operation.follow.FollowInput.Look;
import org.dronemap.cognitive.operation.follow.FollowInput.Looked;
import org.dronemap.cognitive.operation.follow.FollowInput.Other;
import org.dronemap.cognitive.operation.follow.FollowState;
import org.jspecify.annotations.Nullable;

/** Follows as text. */
public final class FollowCodec extends RecordCodec<FollowState, FollowInput> {
    /** Drones were led in no other mode before looks told in which they can be. */
    private static final String LED = "GUIDED";

    private static final String HOMEWARD = "RTL";

    public FollowCodec() {
        super(FollowState.class, FollowInput.class, List.of());
    }

    @Override
    public FollowInput input(String text) {
        FollowInput input = super.input(text);
        if (!(input instanceof Looked looked)) {
            return input;
        }
        return new Looked(
                looked.at(),
                withModes(looked.drone()),
                looked.sighted(),
                looked.reach(),
                looked.unsteered(),
                looked.others().stream()
                        .map(other -> new Other(other.drone(), withModes(other.look()), other.apartMeters()))
                        .toList());
    }

    private static @Nullable Look withModes(@Nullable Look look) {
        if (look == null || look.modes() != null) {
            return look;
        }
        boolean home = look.homing() && look.mode() != null && look.mode().endsWith(HOMEWARD);
        return look.with(new FollowInput.Modes(LED, home));
    }
}
