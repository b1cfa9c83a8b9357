package org.dronemap.proxy.outlet;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.List;
import java.util.stream.IntStream;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.message.ParamRequestList;
import org.dronemap.mavlink.message.ParamRequestRead;
import org.dronemap.mavlink.message.ParamValue;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** Lists of parameters on their way to clients: over links that stall, and where some of it is lost. */
class ClientParameterHandlerTest {
    private static final int COUNT = 1_000;
    private static final int STALLS_AFTER = 300;
    private static final ParamRequestList LIST = new ParamRequestList(1, 1);

    private final OutletTestBench house = new OutletTestBench(COUNT);

    ClientParameterHandlerTest() throws IOException {}

    @AfterEach
    void close() throws IOException {
        house.close();
    }

    @Test
    void aListGoesOnWhereItStoodWhenTheLinkTakesMoreAgain() {
        OutletTestBench.Station slow = house.new Station("ann", 255, ClientParameterHandlerTest::stall);
        OutletTestBench.Station quick = house.new Station("eve", 254);
        slow.says(LIST);
        quick.says(LIST);
        awaitAll(quick);
        assertThat(indices(slow)).hasSize(STALLS_AFTER);
        slow.isStuck(false);
        awaitAll(slow);
        assertThat(indices(slow)).isEqualTo(IntStream.range(0, COUNT).boxed().toList());
    }

    @Test
    void whatWasLostOnTheWayIsHadByItsPlaceOrByItsName() {
        OutletTestBench.Station ann = house.new Station("ann", 255);
        ann.says(LIST);
        awaitAll(ann);
        ParamValue byPlace = ParamValue.decode(ann.answer(ParamValue.ID, new ParamRequestRead(1, 1, "", 507)));
        ParamValue byName = ParamValue.decode(
                ann.answer(ParamValue.ID, new ParamRequestRead(1, 1, MatrixVehicle.name(507), 0xFFFF)));
        assertThat(byPlace).isEqualTo(byName);
        assertThat(byPlace.paramIndex()).isEqualTo(507);
        assertThat(byPlace.paramId()).isEqualTo(MatrixVehicle.name(507));
    }

    @Test
    void theVehicleIsReadOnceForAllWhoAsk() {
        List<OutletTestBench.Station> stations =
                List.of(house.new Station("ann", 255), house.new Station("bob", 254), house.new Station("eve", 253));
        stations.forEach(station -> station.says(LIST));
        stations.forEach(this::awaitAll);
        assertThat(house.reachedVehicle(ParamRequestList.ID)).hasSize(1);
    }

    @Test
    void whoMayNotHaveItReadKeepsNobodyElseFromIt() {
        OutletTestBench.Station eve = house.new Station("eve", 255);
        OutletTestBench.Station ann = house.new Station("ann", 254);
        eve.says(LIST);
        ann.says(LIST);
        eve.awaitText("Your role may look, not command");
        awaitAll(ann);
        eve.says(LIST);
        awaitAll(eve);
    }

    private static void stall(OutletTestBench.Station station, Frame frame) {
        if (frame.messageId() == ParamValue.ID && station.of(ParamValue.ID).size() == STALLS_AFTER) {
            station.isStuck(true);
        }
    }

    private void awaitAll(OutletTestBench.Station station) {
        house.await(() -> station.of(ParamValue.ID).size() >= COUNT, "not all parameters came");
    }

    private static List<Integer> indices(OutletTestBench.Station station) {
        return station.of(ParamValue.ID).stream()
                .map(frame -> ParamValue.decode(frame).paramIndex())
                .toList();
    }
}
