package org.dronemap.ws.openapi;

import io.swagger.v3.oas.models.OpenAPI;
import io.swagger.v3.oas.models.media.Schema;
import java.util.LinkedHashMap;
import java.util.Map;
import org.dronemap.core.command.CommandKind;
import org.dronemap.ws.reading.WireNames;
import org.springdoc.core.customizers.OpenApiCustomizer;

/** Adds to the OpenAPI description the purpose of each command type, which tells clients whether it needs control. */
public final class CommandPurposeCustomizer implements OpenApiCustomizer {
    public static final String PURPOSES = "x-purposes";

    @Override
    public void customise(OpenAPI description) {
        Map<String, String> purposes = new LinkedHashMap<>();
        for (CommandKind kind : CommandKind.values()) {
            purposes.put(WireNames.camel(kind), WireNames.camel(kind.purpose()));
        }
        Schema<?> command = description.getComponents().getSchemas().get("CommandView");
        Schema<?> type =
                command == null ? null : (Schema<?>) command.getProperties().get("type");
        if (type == null) {
            throw new IllegalStateException("The description has no type of a CommandView to say purposes at.");
        }
        type.addExtension(PURPOSES, purposes);
    }
}
