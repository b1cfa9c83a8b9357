package org.dronemap.ws.wire;

import org.dronemap.ws.house.Http;
import org.dronemap.ws.house.SharedServer;
import org.dronemap.ws.house.TestHouse;
import org.junit.jupiter.api.Test;

/** The description of REST that programs are written from, to the letter. */
class RestWireTest {
    @Test
    void isDescribedAsApproved() {
        TestHouse house = SharedServer.get();
        String served = new Http(house, "")
                .get("/api/openapi.json")
                .raw()
                .body()
                .replace("http://127.0.0.1:" + house.httpPort(), "http://dronemap.example");

        Approved.check("openapi.json", PrettyJson.of(PrettyJson.sorted(PrettyJson.tree(served))));
    }
}
