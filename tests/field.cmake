thaum_test(test_field
    SOURCES accuracy/field_test.cpp
    LINK thaum_field thaum_fluid)
