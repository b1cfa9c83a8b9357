package org.dronemap.ws.reading;

import java.util.Collection;
import org.jspecify.annotations.Nullable;
import tools.jackson.core.JsonParser;
import tools.jackson.core.JsonToken;
import tools.jackson.core.util.JsonParserSequence;
import tools.jackson.databind.BeanProperty;
import tools.jackson.databind.DeserializationContext;
import tools.jackson.databind.JavaType;
import tools.jackson.databind.jsontype.NamedType;
import tools.jackson.databind.jsontype.TypeDeserializer;
import tools.jackson.databind.jsontype.impl.AsPropertyTypeDeserializer;
import tools.jackson.databind.jsontype.impl.StdTypeResolverBuilder;
import tools.jackson.databind.util.TokenBuffer;

/** Jackson resolver for bodies that are one of several records: accepts only JSON objects, and nested alternatives. */
public final class ObjectOnlyTypeResolver extends StdTypeResolverBuilder {
    @Override
    public @Nullable TypeDeserializer buildTypeDeserializer(
            DeserializationContext context, JavaType base, Collection<NamedType> named) {
        TypeDeserializer usual = super.buildTypeDeserializer(context, base, named);
        return usual instanceof AsPropertyTypeDeserializer byMember
                ? new ObjectOnlyTypeDeserializer(byMember, null)
                : usual;
    }

    private static final class ObjectOnlyTypeDeserializer extends AsPropertyTypeDeserializer {
        ObjectOnlyTypeDeserializer(AsPropertyTypeDeserializer usual, @Nullable BeanProperty member) {
            super(usual, member);
        }

        @Override
        public TypeDeserializer forProperty(BeanProperty member) {
            return member == _property ? this : new ObjectOnlyTypeDeserializer(this, member);
        }

        @Override
        public Object deserializeTypedFromObject(JsonParser parser, DeserializationContext context) {
            boolean isWithin = parser.hasToken(JsonToken.PROPERTY_NAME) || parser.hasToken(JsonToken.END_OBJECT);
            if (!isWithin && !parser.isExpectedStartObjectToken()) {
                return context.handleUnexpectedToken(_baseType, parser);
            }
            return super.deserializeTypedFromObject(parser, context);
        }

        @Override
        protected Object _deserializeTypedForId(
                JsonParser parser, DeserializationContext context, @Nullable TokenBuffer before, String id) {
            JavaType chosen = _idResolver.typeFromId(context, id);
            if (chosen == null || RecordAlternatives.of(chosen.getRawClass()).isEmpty()) {
                return super._deserializeTypedForId(parser, context, before, id);
            }
            JsonParser rest = parser;
            if (before != null) {
                // What was looked at is read from the buffer again, and the value of the member not at all.
                parser.clearCurrentToken();
                rest = JsonParserSequence.createFlattened(false, before.asParser(context, parser), parser);
            }
            if (rest.currentToken() != JsonToken.END_OBJECT) {
                rest.nextToken();
            }
            return context.findRootValueDeserializer(chosen).deserialize(rest, context);
        }

        @Override
        public Object deserializeTypedFromAny(JsonParser parser, DeserializationContext context) {
            return deserializeTypedFromObject(parser, context);
        }
    }
}
