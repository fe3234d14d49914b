thaum_test(test_field
    SOURCES accuracy/field_test.cpp unit/field_transfer_test.cpp
    LINK thaum_field thaum_fluid)
