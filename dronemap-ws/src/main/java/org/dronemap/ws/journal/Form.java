package org.dronemap.ws.journal;

import tools.jackson.databind.JsonNode;

/** How values of one type are written; what was not written so is refused with an IllegalArgumentException. */
interface Form {
    JsonNode write(Object value);

    Object read(JsonNode node);
}
