package org.dronemap.ws.openapi;

import static org.assertj.core.api.Assertions.assertThat;

import io.swagger.v3.oas.annotations.media.Schema;
import java.util.Arrays;
import java.util.function.Function;
import java.util.stream.Stream;
import org.dronemap.cognitive.follow.StandOffSide;
import org.dronemap.core.command.CommandKind;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.drone.GpsFix;
import org.dronemap.core.mission.MissionItem;
import org.dronemap.proxy.endpoint.EndpointState;
import org.dronemap.proxy.record.ReplayStatus;
import org.dronemap.ws.drone.DroneView;
import org.dronemap.ws.follow.FollowRequest;
import org.dronemap.ws.follow.FollowView;
import org.dronemap.ws.link.EndpointView;
import org.dronemap.ws.reading.WireNames;
import org.dronemap.ws.recording.ReplayView;
import org.junit.jupiter.api.Test;

/** Values that are described beside the code that gives them. */
class AllowedValuesSchemaTest {
    private static String[] values(Class<?> record, String member) throws ReflectiveOperationException {
        return record.getDeclaredField(member).getAnnotation(Schema.class).allowableValues();
    }

    private static <T> String[] words(T[] values, Function<T, String> word) {
        return Arrays.stream(values).map(word).toArray(String[]::new);
    }

    @Test
    void areThoseOfWhatTheyAreReadFrom() throws ReflectiveOperationException {
        assertThat(values(DroneView.GpsView.class, "fix")).containsExactly(words(GpsFix.values(), GpsFix::label));
        assertThat(values(EndpointView.class, "state"))
                .containsExactly(words(EndpointState.Phase.values(), WireNames::camel));
        assertThat(values(ReplayView.class, "state"))
                .containsExactly(words(ReplayStatus.State.values(), WireNames::camel));
        assertThat(Stream.of(FollowView.PlaceView.class, FollowRequest.PlaceRequest.class))
                .allSatisfy(record -> assertThat(values(record, "side"))
                        .containsExactly(words(
                                StandOffSide.class.getPermittedSubclasses(),
                                side -> WireNames.lowerFirst(side.getSimpleName()))));
    }

    @Test
    void areCalledAsTheirEnumsAre() {
        assertThat(CommandKind.values())
                .allSatisfy(
                        kind -> assertThat(WireNames.lowerFirst(kind.word())).isEqualTo(WireNames.camel(kind)));
        assertThat(Outcome.Kind.values())
                .allSatisfy(kind -> assertThat(kind.word()).isEqualTo(WireNames.camel(kind)));
        assertThat(MissionItem.Kind.values())
                .allSatisfy(kind -> assertThat(kind.word()).isEqualTo(WireNames.camel(kind)));
    }
}
