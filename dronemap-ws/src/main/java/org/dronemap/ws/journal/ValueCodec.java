package org.dronemap.ws.journal;

import tools.jackson.databind.JsonNode;

/** Journal codec of one Java type; text in another form is refused with an IllegalArgumentException. */
interface ValueCodec {
    JsonNode write(Object value);

    Object read(JsonNode node);
}
