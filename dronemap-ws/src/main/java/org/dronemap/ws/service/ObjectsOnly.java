package org.dronemap.ws.service;

import java.util.Collection;
import org.jspecify.annotations.Nullable;
import tools.jackson.core.JsonParser;
import tools.jackson.core.JsonToken;
import tools.jackson.databind.BeanProperty;
import tools.jackson.databind.DeserializationContext;
import tools.jackson.databind.JavaType;
import tools.jackson.databind.jsontype.NamedType;
import tools.jackson.databind.jsontype.TypeDeserializer;
import tools.jackson.databind.jsontype.impl.AsPropertyTypeDeserializer;
import tools.jackson.databind.jsontype.impl.StdTypeResolverBuilder;

/** A reader of alternatives that takes objects alone: the usual one takes {@code ["arm", {}]} for an object too. */
public final class ObjectsOnly extends StdTypeResolverBuilder {
    @Override
    public @Nullable TypeDeserializer buildTypeDeserializer(
            DeserializationContext context, JavaType base, Collection<NamedType> named) {
        TypeDeserializer usual = super.buildTypeDeserializer(context, base, named);
        return usual instanceof AsPropertyTypeDeserializer byMember ? new OfObjects(byMember, null) : usual;
    }

    private static final class OfObjects extends AsPropertyTypeDeserializer {
        OfObjects(AsPropertyTypeDeserializer usual, @Nullable BeanProperty member) {
            super(usual, member);
        }

        @Override
        public TypeDeserializer forProperty(BeanProperty member) {
            return member == _property ? this : new OfObjects(this, member);
        }

        @Override
        public Object deserializeTypedFromObject(JsonParser parser, DeserializationContext context) {
            if (!parser.isExpectedStartObjectToken() && !parser.hasToken(JsonToken.PROPERTY_NAME)) {
                return context.handleUnexpectedToken(_baseType, parser);
            }
            return super.deserializeTypedFromObject(parser, context);
        }

        @Override
        public Object deserializeTypedFromAny(JsonParser parser, DeserializationContext context) {
            return deserializeTypedFromObject(parser, context);
        }
    }
}
