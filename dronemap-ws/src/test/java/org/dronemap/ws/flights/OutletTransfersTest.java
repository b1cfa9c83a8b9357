package org.dronemap.ws.flights;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.dronemap.core.access.Role;
import org.dronemap.mavlink.message.MissionAck;
import org.dronemap.mavlink.message.MissionCount;
import org.dronemap.mavlink.message.MissionItemInt;
import org.dronemap.mavlink.message.MissionRequestInt;
import org.dronemap.mavlink.message.MissionRequestList;
import org.dronemap.mavlink.message.ParamRequestList;
import org.dronemap.mavlink.message.ParamRequestRead;
import org.dronemap.mavlink.message.ParamSet;
import org.dronemap.mavlink.message.ParamValue;
import org.dronemap.ws.lab.Administrator;
import org.dronemap.ws.lab.CommandRequests;
import org.dronemap.ws.lab.GroundStation;
import org.dronemap.ws.lab.LabDrone;
import org.dronemap.ws.lab.LabPeerLink;
import org.dronemap.ws.lab.LabVehicleLink;
import org.dronemap.ws.lab.Laboratory;
import org.dronemap.ws.lab.Pilot;
import org.dronemap.ws.lab.VehicleFrameLog;
import org.dronemap.ws.lab.VehicleSpec;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** Ground stations of other makers read and write missions and parameters through the outlet. */
class OutletTransfersTest {
    private static final Duration SOON = Duration.ofSeconds(30);
    private static final Duration LONGEST = Duration.ofSeconds(60);
    private static final int PARAMETERS = 1_000;
    private static final int MISSION_ACCEPTED = 0;
    private static final int MISSION_DENIED = 14;
    private static final int GAPS_AT_ONCE = 50;
    private static final int REAL32 = 9;

    private final Laboratory lab = new Laboratory(1);
    private final LabDrone copter = lab.ready(lab.add(VehicleSpec.COPTER.withParameters(PARAMETERS)));
    private final VehicleFrameLog log = new VehicleFrameLog(copter);
    private final Administrator administrator = lab.administrator();

    /** As items carry it: 1e-7 degrees and metres. */
    private record Place(int x, int y, float z) {}

    @AfterEach
    void close() {
        lab.close();
    }

    private GroundStation station(Pilot user, int systemId) {
        return lab.station(LabPeerLink.Kind.TCP, user.passphrase(), systemId);
    }

    private Pilot user(Role role) {
        return administrator.granted(role.name(), role, copter);
    }

    /** Sends a mission as ground stations do; the type of its acknowledgement. */
    private int upload(GroundStation ground, int number, List<Place> places) {
        int before = ground.heard(MissionAck.ID, number).size();
        int[] asked = {ground.heard(MissionRequestInt.ID, number).size()};
        ground.says(new MissionCount(number, 1, places.size(), 0));
        lab.until("it is acknowledged", LONGEST, () -> {
            List<MissionRequestInt> requests = ground.heard(MissionRequestInt.ID, number, MissionRequestInt::decode);
            for (; asked[0] < requests.size(); asked[0]++) {
                int seq = requests.get(asked[0]).seq();
                ground.says(item(number, seq, places.get(seq)));
            }
            return ground.heard(MissionAck.ID, number).size() > before;
        });
        return ground.heard(MissionAck.ID, number, MissionAck::decode)
                .get(before)
                .type();
    }

    private static MissionItemInt item(int number, int seq, Place at) {
        int frame = seq == 0 ? 0 : 3;
        return new MissionItemInt(number, 1, seq, frame, 16, 0, 1, 0, 0, 0, 0, at.x(), at.y(), at.z(), 0);
    }

    /** The mission as a client reads it. */
    private List<Place> items(GroundStation ground, int number) {
        int before = ground.heard(MissionCount.ID, number).size();
        ground.says(new MissionRequestList(number, 1, 0));
        int count = lab.until(
                        "it is counted",
                        SOON,
                        () -> ground.heard(MissionCount.ID, number, MissionCount::decode).stream()
                                .skip(before)
                                .findFirst())
                .count();
        List<Place> read = new ArrayList<>();
        for (int seq = 0; seq < count; seq++) {
            int wanted = seq;
            int had = ground.heard(MissionItemInt.ID, number).size();
            ground.says(new MissionRequestInt(number, 1, seq, 0));
            MissionItemInt item = lab.until(
                    "item " + seq + " comes",
                    SOON,
                    () -> ground.heard(MissionItemInt.ID, number, MissionItemInt::decode).stream()
                            .skip(had)
                            .filter(one -> one.seq() == wanted)
                            .findFirst());
            read.add(new Place(item.x(), item.y(), item.z()));
        }
        ground.says(new MissionAck(number, 1, 0, 0));
        return read;
    }

    @Test
    void missionsAreWrittenByOneAndReadByAllWithoutAnotherTransfer() {
        Pilot viewer = user(Role.VIEWER);
        List<GroundStation> grounds = new ArrayList<>();
        grounds.add(station(user(Role.PLANNER), 255));
        grounds.add(station(viewer, 255));
        for (int more = 0; more < 3; more++) {
            grounds.add(station(viewer, 250 + more));
        }
        List<Place> places = new ArrayList<>();
        for (int index = 0; index <= 200; index++) {
            places.add(new Place(473_977_000 + 100 * index, 85_456_000 + 100 * index, 20));
        }
        int number = grounds.get(0).hears(1).get(0);
        assertThat(upload(grounds.get(0), number, places)).isEqualTo(MISSION_ACCEPTED);
        lab.until(
                "it is read back",
                SOON,
                () -> Optional.ofNullable(copter.state().mission().items())
                                .orElse(List.of())
                                .size()
                        == 200);
        int read = log.said(MissionItemInt.ID).size();
        for (GroundStation ground : grounds) {
            List<Place> own = items(ground, ground.hears(1).get(0));
            assertThat(own.subList(1, own.size())).isEqualTo(places.subList(1, places.size()));
        }
        // The cloud itself looks once more whether all is as it was.
        assertThat(log.said(MissionItemInt.ID)).hasSizeLessThanOrEqualTo(read + places.size());
    }

    @Test
    void aViewerWritesNoMissionAndOnlyAHomeClearsIt() {
        GroundStation viewer = station(user(Role.VIEWER), 255);
        Place place = new Place(473_977_000, 85_456_000, 20);
        assertThat(upload(viewer, viewer.hears(1).get(0), List.of(place, place)))
                .isEqualTo(MISSION_DENIED);
        assertThat(log.told(MissionCount.ID)).isEmpty();
        assertThat(log.told(MissionItemInt.ID)).isEmpty();

        GroundStation planner = station(user(Role.PLANNER), 255);
        int number = planner.hears(1).get(0);
        planner.says(new MissionCount(number, 1, 1, 0));
        lab.until(
                "it asks",
                SOON,
                () -> !planner.heard(MissionRequestInt.ID, number).isEmpty());
        planner.says(new MissionItemInt(number, 1, 0, 3, 16, 0, 1, 0, 0, 0, 0, place.x(), place.y(), place.z(), 0));
        lab.until(
                "it is answered",
                SOON,
                () -> !planner.heard(MissionAck.ID, number).isEmpty());
        assertThat(planner.heard(MissionAck.ID, number, MissionAck::decode)
                        .get(0)
                        .type())
                .isEqualTo(MISSION_ACCEPTED);
    }

    /** Places in the list of parameters that did not come; null as long as nothing came. */
    private static Set<Integer> missing(List<ParamValue> values) {
        Set<Integer> missing = new HashSet<>();
        int count = values.isEmpty() ? PARAMETERS : values.get(0).paramCount();
        for (int index = 0; index < count; index++) {
            missing.add(index);
        }
        values.forEach(value -> missing.remove(value.paramIndex()));
        return missing;
    }

    private static Set<Integer> missing(GroundStation ground, int number) {
        return missing(ground.heard(ParamValue.ID, number, ParamValue::decode));
    }

    @Test
    void fiveClientsLoadAllParametersAndTheVehicleIsReadOnce() {
        List<Pilot> users = List.of(
                administrator.granted("ann", Role.OPERATOR, copter),
                administrator.granted("bob", Role.OPERATOR, copter),
                administrator.granted("eve", Role.VIEWER, copter));
        GroundStation byUdp = lab.station(users.get(0), 251);
        List<GroundStation> byTcp = new ArrayList<>();
        for (int more = 1; more < 5; more++) {
            byTcp.add(station(users.get(more % 3), 251 + more));
        }
        int number = byUdp.hears(1).get(0);
        byUdp.line().is(new LabVehicleLink.Quality(0.05, Duration.ofMillis(5), Duration.ZERO));
        byUdp.says(new ParamRequestList(number, 1));
        for (GroundStation ground : byTcp) {
            ground.says(new ParamRequestList(ground.hears(1).get(0), 1));
        }
        for (GroundStation ground : byTcp) {
            int its = ground.hears(1).get(0);
            // By TCP nothing is lost: none of these asks twice.
            lab.until(
                    "all parameters came by TCP",
                    LONGEST,
                    () -> ground.heard(ParamValue.ID, its).size() >= PARAMETERS
                            && missing(ground, its).isEmpty());
            assertThat(ground.heard(ParamValue.ID, its, ParamValue::decode)
                            .get(0)
                            .paramCount())
                    .isGreaterThanOrEqualTo(PARAMETERS);
        }
        // By UDP, as ground stations do: what is missing when nothing more comes is asked for again.
        for (int round = 0; round < 60 && !missing(byUdp, number).isEmpty(); round++) {
            missing(byUdp, number).stream()
                    .limit(GAPS_AT_ONCE)
                    .forEach(index -> byUdp.says(new ParamRequestRead(number, 1, "", index)));
            lab.goOn(Duration.ofSeconds(1));
        }
        assertThat(missing(byUdp, number)).isEmpty();
        assertThat(byUdp.heard(ParamValue.ID, number, ParamValue::decode).get(0).paramCount())
                .isGreaterThanOrEqualTo(PARAMETERS);
        assertThat(log.told(ParamRequestList.ID)).hasSize(1);
    }

    private ParamValue answer(GroundStation ground, int number) {
        lab.until(
                "it is answered",
                SOON,
                () -> !ground.heard(ParamValue.ID, number).isEmpty());
        List<ParamValue> told = ground.heard(ParamValue.ID, number, ParamValue::decode);
        return told.get(told.size() - 1);
    }

    @Test
    void whoSetsAParameterIsAnsweredThoughTheListWasNeverRead() {
        GroundStation ground = station(user(Role.OPERATOR), 255);
        int number = ground.hears(1).get(0);
        ground.says(new ParamSet(number, 1, "RTL_ALT", 2_100, REAL32));
        ParamValue told = answer(ground, number);
        assertThat(List.of(told.paramId(), told.paramValue(), told.paramIndex()))
                .containsExactly("RTL_ALT", 2_100f, 0xFFFF);
        assertThat(log.told(ParamSet.ID)).hasSize(1);
    }

    @Test
    void aParameterIsSetByWhoMayAndToldAsItIsToOthers() {
        administrator.account().does(copter, CommandRequests.readParameters());
        for (Role role : List.of(Role.OPERATOR, Role.VIEWER)) {
            GroundStation ground = station(user(role), 255);
            int number = ground.hears(1).get(0);
            float wanted = role == Role.OPERATOR ? 2_100 : 900;
            ground.says(new ParamSet(number, 1, "RTL_ALT", wanted, REAL32));
            ParamValue last = answer(ground, number);
            assertThat(List.of(last.paramId(), last.paramValue())).containsExactly("RTL_ALT", 2_100f);
        }
        assertThat(log.told(ParamSet.ID))
                .isNotEmpty()
                .allMatch(frame -> ParamSet.decode(frame).paramValue() == 2_100f);
    }
}
