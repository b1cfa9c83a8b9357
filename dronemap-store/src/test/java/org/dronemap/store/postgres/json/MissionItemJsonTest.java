package org.dronemap.store.postgres.json;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.mission.LandingPlace;
import org.dronemap.core.mission.MissionItem;
import org.dronemap.store.StoreException;
import org.junit.jupiter.api.Test;

class MissionItemJsonTest {
    @Test
    void writesTheFormThatIsStored() {
        String json = MissionItemJson.write(List.of(
                new MissionItem.TakeOff(20),
                new MissionItem.Waypoint(new Geodetic(47.5, 8.25), new Altitude(500, Altitude.Reference.AMSL), 1.5),
                new MissionItem.ReturnToLaunch(),
                new MissionItem.Land(),
                new MissionItem.Land(
                        new LandingPlace(new Geodetic(47.5, 8.25), new Altitude(4, Altitude.Reference.HOME))),
                new MissionItem.Wait(2.5),
                new MissionItem.TakePhoto(),
                new MissionItem.SetServo(9, 1_900),
                new MissionItem.LookAt(new Geodetic(47.5, 8.25), new Altitude(-3, Altitude.Reference.HOME)),
                new MissionItem.LookAhead(),
                new MissionItem.Other("set servo 9")));
        assertThat(json)
                .isEqualTo("[{\"type\":\"takeOff\",\"altitudeMeters\":20.0},"
                        + "{\"type\":\"waypoint\",\"latitudeDegrees\":47.5,\"longitudeDegrees\":8.25,"
                        + "\"altitudeMeters\":500.0,\"altitudeReference\":\"amsl\",\"holdSeconds\":1.5},"
                        + "{\"type\":\"returnToLaunch\"},{\"type\":\"land\"},"
                        + "{\"type\":\"land\",\"latitudeDegrees\":47.5,\"longitudeDegrees\":8.25,"
                        + "\"altitudeMeters\":4.0,\"altitudeReference\":\"home\"},"
                        + "{\"type\":\"wait\",\"seconds\":2.5},{\"type\":\"takePhoto\"},"
                        + "{\"type\":\"setServo\",\"output\":9,\"pulseMicros\":1900},"
                        + "{\"type\":\"lookAt\",\"latitudeDegrees\":47.5,\"longitudeDegrees\":8.25,"
                        + "\"altitudeMeters\":-3.0,\"altitudeReference\":\"home\"},{\"type\":\"lookAhead\"},"
                        + "{\"type\":\"other\",\"description\":\"set servo 9\"}]");
    }

    @Test
    void readsBackExactlyWhatItWrote() {
        Random random = new Random(7);
        List<MissionItem> items = new ArrayList<>();
        for (int i = 0; i < 500; i++) {
            items.add(new MissionItem.Waypoint(
                    new Geodetic(random.nextDouble() * 180 - 90, random.nextDouble() * 360 - 180),
                    new Altitude(
                            random.nextDouble() * 1_000 - 100,
                            random.nextBoolean() ? Altitude.Reference.HOME : Altitude.Reference.AMSL),
                    random.nextDouble() * 100));
        }
        items.add(new MissionItem.TakeOff(Double.NaN));
        items.add(new MissionItem.Wait(0.1));
        items.add(new MissionItem.Land());
        items.add(new MissionItem.Land(
                new LandingPlace(new Geodetic(-1.25, 179), new Altitude(420.5, Altitude.Reference.AMSL))));
        items.add(new MissionItem.TakePhoto());
        items.add(new MissionItem.SetServo(32, 2_500));
        items.add(new MissionItem.LookAt(new Geodetic(-1.5, 179), new Altitude(9_000, Altitude.Reference.AMSL)));
        items.add(new MissionItem.LookAhead());
        items.add(new MissionItem.Waypoint(new Geodetic(-0.0, 0), Altitude.aboveHome(1), Double.POSITIVE_INFINITY));
        items.add(new MissionItem.Other("\u0000 \" \\ 🚁"));
        assertThat(MissionItemJson.read(MissionItemJson.write(items))).isEqualTo(items);
    }

    @Test
    void saysWhatItCannotRead() {
        assertThatThrownBy(() -> MissionItemJson.read("[{\"type\":\"loop\"}]"))
                .isInstanceOf(StoreException.class)
                .hasMessageContaining("unknown mission item type \"loop\"");
        assertThatThrownBy(() -> MissionItemJson.read("[{\"type\":\"takeOff\"}]"))
                .isInstanceOf(StoreException.class)
                .hasMessageContaining("altitudeMeters");
        assertThatThrownBy(() -> MissionItemJson.read("[{")).isInstanceOf(StoreException.class);
    }
}
