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
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.TreeMap;
import org.dronemap.ws.stream.StreamMessage;
import org.dronemap.ws.stream.StreamMessageCatalogue;
import org.dronemap.ws.stream.StreamRequest;
import org.dronemap.ws.stream.StreamServer;
import org.springdoc.core.customizers.OpenApiCustomizer;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.ObjectNode;

/** Makes the JSON schemas of all messages of the WebSocket stream, in the same way as those of REST. */
final class StreamSchemas {
    private static final String REFERENCE = "#/components/schemas/";
    private static final String SAID = "StreamMessage";
    private static final String DISCRIMINATOR = "discriminator";

    private StreamSchemas() {}

    /** By name, in the order of their names; {@code customizers}: those of the description of REST. */
    @SuppressWarnings("rawtypes")
    static ObjectNode of(StreamMessageCatalogue said, List<OpenApiCustomizer> customizers, JsonMapper json) {
        Map<String, Schema> schemas = new TreeMap<>();
        schemas.putAll(ModelConverters.getInstance(true).readAll(StreamMessage.class));
        said.ofUseCases().forEach((type, record) -> add(schemas, type, record));
        schemas.putAll(ModelConverters.getInstance(true).readAll(StreamRequest.class));
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

    /** A message that is declared beside its use case is one of those that the server says. */
    @SuppressWarnings("rawtypes")
    private static void add(Map<String, Schema> schemas, String type, Class<?> record) {
        ResolvedSchema one =
                ModelConverters.getInstance(true).readAllAsResolvedSchema(new AnnotatedType(record).resolveAsRef(true));
        schemas.putAll(one.referencedSchemas);
        Schema<?> choice = Objects.requireNonNull(schemas.get(SAID));
        choice.addOneOfItem(one.schema);
        choice.getDiscriminator().mapping(type, one.schema.get$ref());
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
