package org.dronemap.ws.journal;

import java.util.List;
import java.util.function.UnaryOperator;
import org.dronemap.cognitive.operation.follow.FollowInput;
import org.dronemap.cognitive.operation.follow.FollowInput.ModeMeaning;
import org.dronemap.cognitive.operation.follow.FollowInput.Observation;
import org.dronemap.cognitive.operation.follow.FollowInput.Observed;
import org.dronemap.cognitive.operation.follow.FollowInput.OtherDrone;
import org.dronemap.cognitive.operation.follow.FollowState;
import org.jspecify.annotations.Nullable;

/** Reads and writes states and inputs of follows as text for the journal of operations. */
public final class FollowJournalCodec extends JsonOperationCodec<FollowState, FollowInput> {
    /** Drones were led in no other mode before looks told in which they can be. */
    private static final String LED = "GUIDED";

    private static final String HOMEWARD = "RTL";

    public FollowJournalCodec() {
        super(FollowState.class, FollowInput.class, List.of());
    }

    @Override
    public FollowInput input(String text) {
        return looking(super.input(text), FollowJournalCodec::withModes);
    }

    /** What can be told of a look without its modes is left out of it, as it was before it told of them. */
    @Override
    public String input(FollowInput input) {
        return super.input(looking(input, FollowJournalCodec::withoutUsualModes));
    }

    private static FollowInput looking(FollowInput input, UnaryOperator<Observation> change) {
        return input instanceof Observed looked
                ? new Observed(
                        looked.at(),
                        changed(looked.drone(), change),
                        looked.lastReport(),
                        looked.reach(),
                        looked.steeringRefusal(),
                        looked.others().stream()
                                .map(other -> new OtherDrone(
                                        other.drone(), changed(other.look(), change), other.apartMeters()))
                                .toList())
                : input;
    }

    private static @Nullable Observation changed(@Nullable Observation look, UnaryOperator<Observation> change) {
        return look == null ? null : change.apply(look);
    }

    private static Observation withModes(Observation look) {
        return look.modes() == null ? look.with(usual(look)) : look;
    }

    private static Observation withoutUsualModes(Observation look) {
        return usual(look).equals(look.modes()) ? look.with(null) : look;
    }

    private static ModeMeaning usual(Observation look) {
        boolean home = look.homing() && look.mode() != null && look.mode().endsWith(HOMEWARD);
        return new ModeMeaning(LED, home);
    }
}
