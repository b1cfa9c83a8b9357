package org.dronemap.ws.stream.description;

import com.fasterxml.jackson.core.JsonProcessingException;
import io.swagger.v3.core.converter.AnnotatedType;
import io.swagger.v3.core.converter.ModelConverters;
import io.swagger.v3.core.converter.ResolvedSchema;
import io.swagger.v3.core.util.Json31;
import io.swagger.v3.oas.models.Components;
import io.swagger.v3.oas.models.OpenAPI;
import io.swagger.v3.oas.models.Operation;
import io.swagger.v3.oas.models.PathItem;
import io.swagger.v3.oas.models.Paths;
import io.swagger.v3.oas.models.media.Content;
import io.swagger.v3.oas.models.media.MediaType;
import io.swagger.v3.oas.models.media.Schema;
import io.swagger.v3.oas.models.parameters.RequestBody;
import io.swagger.v3.oas.models.responses.ApiResponses;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.TreeMap;
import org.dronemap.ws.stream.StreamMessage;
import org.dronemap.ws.stream.StreamMessageCatalogue;
import org.dronemap.ws.stream.StreamRequest;
import org.dronemap.ws.stream.StreamRequestCatalogue;
import org.dronemap.ws.stream.StreamServer;
import org.springdoc.core.customizers.OpenApiCustomizer;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.ObjectNode;

/** Makes the JSON schemas of all messages of the WebSocket stream, in the same way as those of REST. */
final class StreamSchemas {
    private static final String REFERENCE = "#/components/schemas/";
    private static final String DISCRIMINATOR = "discriminator";

    private StreamSchemas() {}

    /** By name, in the order of their names; {@code customizers}: those of the description of REST. */
    @SuppressWarnings("rawtypes")
    static ObjectNode of(
            StreamMessageCatalogue said,
            StreamRequestCatalogue requests,
            List<OpenApiCustomizer> customizers,
            JsonMapper json) {
        Map<String, Schema> schemas = new TreeMap<>();
        addChoice(schemas, StreamMessage.class, said.records());
        addChoice(schemas, StreamRequest.class, requests.alternatives().records());
        OpenAPI description = asRest(schemas);
        customizers.forEach(customizer -> customizer.customise(description));
        try {
            JsonNode written = json.readTree(Json31.mapper().writeValueAsString(schemas));
            nameDiscriminators(written);
            return (ObjectNode) written;
        } catch (JsonProcessingException e) {
            throw new IllegalStateException("the schemas of the stream cannot be written", e);
        }
    }

    /** Those that are declared beside their use cases are among those to choose from. */
    @SuppressWarnings("rawtypes")
    private static void addChoice(Map<String, Schema> schemas, Class<?> type, Map<String, Class<?>> records) {
        ModelConverters converters = ModelConverters.getInstance(true);
        schemas.putAll(converters.readAll(type));
        Schema<?> choice = Objects.requireNonNull(schemas.get(type.getSimpleName()));
        choice.setOneOf(new ArrayList<>());
        records.forEach((name, record) -> {
            ResolvedSchema one = converters.readAllAsResolvedSchema(new AnnotatedType(record).resolveAsRef(true));
            schemas.putAll(one.referencedSchemas);
            choice.addOneOfItem(one.schema);
            choice.getDiscriminator().mapping(name, one.schema.get$ref());
        });
        schemas.put(type.getSimpleName(), choice);
    }

    /** What is sent and what is answered differ in what has to be there: as if requests were bodies of one operation. */
    @SuppressWarnings("rawtypes")
    private static OpenAPI asRest(Map<String, Schema> schemas) {
        Schema<Object> request = new Schema<>();
        request.set$ref(REFERENCE + "StreamRequest");
        Operation operation = new Operation()
                .requestBody(new RequestBody()
                        .content(new Content().addMediaType("application/json", new MediaType().schema(request))))
                .responses(new ApiResponses());
        return new OpenAPI()
                .paths(new Paths().addPathItem(StreamServer.PATH, new PathItem().post(operation)))
                .components(new Components().schemas(schemas));
    }

    /** AsyncAPI takes the name of the member alone; its values stand in the schemas that there are to choose from. */
    private static void nameDiscriminators(JsonNode node) {
        if (node instanceof ObjectNode object) {
            if (object.get(DISCRIMINATOR) instanceof ObjectNode told) {
                object.set(DISCRIMINATOR, told.get("propertyName"));
            }
            object.values().forEach(StreamSchemas::nameDiscriminators);
        } else if (node instanceof ArrayNode array) {
            array.values().forEach(StreamSchemas::nameDiscriminators);
        }
    }
}
