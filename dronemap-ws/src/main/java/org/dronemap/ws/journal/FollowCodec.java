package org.dronemap.ws.journal;

import java.util.List;
import org.dronemap.cognitive.operation.follow.FollowInput;
import org.dronemap.cognitive.operation.follow.FollowState;

/** Follows as text. */
public final class FollowCodec extends RecordCodec<FollowState, FollowInput> {
    public FollowCodec() {
        super(FollowState.class, FollowInput.class, List.of());
    }
}
